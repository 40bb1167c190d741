#pragma once

#include "random.h"
#include "surfaces/deformable.h"

#include <functional>
#include <vector>

namespace braidx::test {

/// How a tube is made of unknowns.
struct Kind {
    const char* name;
    int degree, block;
    bool smooth;
};
inline constexpr Kind cable{"cable", 1, 3, false}, smooth_cable{"smooth cable", 1, 3, true},
    quadratic_cable{"quadratic cable", 2, 3, false}, beam{"beam", 1, 9, false},
    smooth_beam{"smooth beam", 1, 9, true}, quadratic_beam{"quadratic beam", 2, 9, false};
inline constexpr Kind all_kinds[] = {cable, smooth_cable, quadratic_cable,
                                     beam,  smooth_beam,  quadratic_beam};

/// Tubes, and skins (patches.h), and their unknowns in engine numbering.
struct Rods {
    std::vector<Tube> tubes;
    std::vector<double> q;
    std::vector<Skin> skins = {};

    DeformableSurfaces surfaces() const { return {tubes, skins}; }

    Vec3 node(std::size_t tube, std::int32_t i) const {
        return vector_at(q, tubes[tube].unknown_of(i));
    }

    /// A tube along curve(t), t from 0 to 1; its rest length is that of the polygon through its
    /// nodes. Directors, if any, are orthonormal and normal to the curve.
    void add(const Kind& kind, int num_elements, double radius,
             const std::function<Vec3(double)>& curve);
    void add_straight(const Kind& kind, int num_elements, double radius, const Vec3& from,
                      const Vec3& to);

    /// Moves every component of every unknown by up to `size`.
    void shake(Random& random, double size);

    /// Makes all sections of beams round again, and turns each by some rotation of its own.
    void turn_sections(Random& random);

    /// The same unknowns with the tubes, and the skins, listed the other way round.
    Rods reversed() const {
        return {{tubes.rbegin(), tubes.rend()}, q, {skins.rbegin(), skins.rend()}};
    }
};

} // namespace braidx::test
