#pragma once

#include "facing.h"
#include "half_width.h"

#include <array>

namespace braidx {

/// A contact element as a linear combination of vector unknowns X_i (positions and directors):
///
///   d(gap)    = sum_i gap_weight_i . dX_i
///   x_b - x_a = sum_i slip_weight_i X_i       (material particles, on which friction acts)
///   d2(gap)   = - sum_section share dX . (second derivative of the half width) dX
///               + the sliding of sections (sliding.h)
///
/// The half width of a beam (half_width.h) is that at the nodes, interpolated in between: a round
/// section that turns leaves the gap unchanged, also where it turns more than the next one
/// (interpolated directors would get shorter there).
struct LocalSystem {
    /// Two facets have 18 unknowns, two beams of degree 2 have 18 and 8 more where they moved on
    /// to.
    static constexpr int capacity = 36;
    using Weights = std::array<double, capacity>;
    using Numbers = std::array<std::int64_t, capacity>;

    int count_a = 0; ///< unknowns [0, count_a) belong to a
    int count_frozen =
        0; ///< [count_a, count_frozen) to b; all of these support the element's own sections
    int count = 0;     ///< the rest came in as the sections moved on
    Numbers unknown{}; ///< engine number of the first component
    std::array<bool, capacity> of_b{};
    std::array<Vec3, capacity> gap_weight; ///< of unknowns in use
    Weights slip_weight{};
    struct Section { ///< share of a node's section in a side's half width
        double share;
        std::array<int, 2> director; ///< their indices
        HalfWidth half_width;
    };
    int num_sections = 0;
    std::array<Section, 6> sections;
    double gap = 0;                 ///< mm, negative = penetration
    Vec3 separation = Vec3::Zero(); ///< x_b - x_a of the material particles, mm
    Facing facing;                  ///< where the sections are, and the normal that follows
    Vec3 own_normal;                ///< of the element when it was made

    /// Index of a vector unknown; `count` if it is not among them.
    int find(std::int64_t number) const;

    /// Index of a vector unknown, which is added if it is new.
    int index_of(std::int64_t number, bool belongs_to_b);
};

/// Gap, separation and weights at the unknowns q.
LocalSystem local_system(const DeformableSurfaces& surfaces, const ContactElement& element,
                         Unknowns q);

/// Only x_b - x_a of the material particles and the gap at the element's own sections.
LocalSystem frozen_system(const DeformableSurfaces& surfaces, const ContactElement& element,
                          Unknowns q);

} // namespace braidx
