#pragma once

#include "../pairing/contact_element.h"

#include <array>

namespace braidx {

/// A contact element as a linear combination of vector unknowns X_i (positions and directors):
///
///   d(gap)              = sum_i gap_weight_i N . dX_i
///   x_b - x_a           = sum_i slip_weight_i X_i          (material particles, on which friction acts)
///   d2(gap)             = - sum_side (sum_{i in side} spin_weight_i N . dX_i)^2
///
/// The half width of a beam's section along N is h(N) = r sqrt((g1.N)^2 + (g2.N)^2): a spinning round section
/// leaves the gap unchanged, and h's second derivative is the last line.
struct LocalSystem {
    static constexpr int capacity = 24;
    using Weights = std::array<double, capacity>;

    int count_a = 0; ///< unknowns [0, count_a) belong to a, [count_a, count) to b
    int count = 0;
    std::array<std::int64_t, capacity> unknown{}; ///< engine number of the first component
    Weights gap_weight{}, slip_weight{}, spin_weight{};
    double gap = 0;                  ///< mm, negative = penetration
    Vec3 separation = Vec3::Zero();  ///< x_b - x_a of the material particles, mm

    bool same_side(int i, int j) const { return (i < count_a) == (j < count_a); }
};

LocalSystem local_system(const std::vector<Tube>& tubes, const ContactElement& element, Unknowns q);

} // namespace braidx
