#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>

namespace braidx {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Current values of all unknowns of all bodies, in engine numbering (mm for positions).
using Unknowns = std::span<const double>;

/// Three consecutive unknowns (a position or a director) as a vector.
inline Vec3 vector_at(Unknowns q, std::int64_t first) {
    return Eigen::Map<const Vec3>(q.data() + first);
}

} // namespace braidx
