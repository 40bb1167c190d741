#pragma once

#include "../types.h"

#include <array>

namespace braidx {

/// Half width of a beam's section across a normal N, over the radius, and its derivatives with the
/// directors g1, g2:
///
///   h = |w| / |c|,   c_a = g_a . N,   w = c_1 g_1 + c_2 g_2.
///
/// w is the direction in the section's plane that faces N; |w| / |c| is how much the section is
/// stretched along it. Rotations of a section, spin and tilt alike, leave h unchanged: a yarn is as
/// thick where its sections are not normal to it. (The support function |c| would make it thinner
/// there, and soft sections that tilt to and fro from node to node would let yarns approach.)
struct HalfWidth {
    double value = 1;
    std::array<Vec3, 2> gradient;               ///< with g1 and g2
    std::array<std::array<Mat3, 2>, 2> hessian; ///< with pairs of them
};

HalfWidth half_width(const std::array<Vec3, 2>& directors, const Vec3& normal);

} // namespace braidx
