#pragma once

#include "facing.h"

#include <array>

namespace braidx {

/// A contact element as a linear combination of vector unknowns X_i (positions and directors):
///
///   d(gap)    = sum_i gap_weight_i N_i . dX_i    (N_i: of positions the normal that follows, of
///   directors the
///                                                 element's own, frozen one)
///   x_b - x_a = sum_i slip_weight_i X_i          (material particles, on which friction acts)
///   d2(gap)   = - sum_section share (sum_{i in section} spin_weight_i N_i . dX_i)^2 + the sliding
///   of sections (sliding.h)
///
/// The half width of a beam along N is h(N) = r sqrt((g1.N)^2 + (g2.N)^2) at the nodes and
/// interpolated in between: a spinning round section leaves the gap unchanged, also where it spins
/// more than the next one (interpolated directors would get shorter there). h's second derivative
/// is the first part of the last line.
struct LocalSystem {
    static constexpr int capacity = 36;
    using Weights = std::array<double, capacity>;
    using Numbers = std::array<std::int64_t, capacity>;

    int count_a = 0; ///< unknowns [0, count_a) belong to a
    int count_frozen =
        0; ///< [count_a, count_frozen) to b; all of these support the element's own sections
    int count = 0;     ///< the rest came in as the sections moved on
    Numbers unknown{}; ///< engine number of the first component
    Numbers section{}; ///< of directors: first unknown of their node; of positions: -1
    std::array<bool, capacity> of_b{};
    Weights gap_weight{}, slip_weight{}, spin_weight{};
    Weights share{};                ///< of directors: share of their node in the half width
    double gap = 0;                 ///< mm, negative = penetration
    Vec3 separation = Vec3::Zero(); ///< x_b - x_a of the material particles, mm
    Facing facing;                  ///< where the sections are, and the normal that follows
    Vec3 own_normal;                ///< of the element when it was made

    /// Whether both are directors of one node.
    bool same_section(int i, int j) const {
        return section[i] >= 0 && section[i] == section[j] && of_b[i] == of_b[j];
    }

    /// N_i.
    const Vec3& normal(int i) const { return section[i] >= 0 ? own_normal : facing.normal; }

    /// Index of a vector unknown, which is added if it is new.
    int index_of(std::int64_t number, bool belongs_to_b);
};

/// Gap, separation and weights at the unknowns q.
LocalSystem local_system(const std::vector<Tube>& tubes, const ContactElement& element, Unknowns q);

/// Only x_b - x_a of the material particles and the gap at the element's own sections.
LocalSystem frozen_system(const std::vector<Tube>& tubes, const ContactElement& element,
                          Unknowns q);

} // namespace braidx
