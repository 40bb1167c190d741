#pragma once

#include "../surfaces/tube.h"
#include "current_skin.h"

#include <optional>
#include <vector>

namespace braidx {

/// The elements of a tube that come within reach (mm) of a box.
class NearStretches {
public:
    NearStretches(const Tube& tube, Unknowns q, const Box& box, double reach);

    bool empty() const { return chords_.empty(); }

    /// Section whose centre is nearest to a place x in the box; nothing where it is far beyond
    /// reach or past an end of the tube.
    std::optional<double> nearest_section(const Vec3& x) const;

private:
    struct Chord {
        std::int32_t element;
        Vec3 from, way;
    };
    const Tube& tube_;
    Unknowns q_;
    double reach_;
    std::vector<Chord> chords_;
};

} // namespace braidx
