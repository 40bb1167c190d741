#pragma once

#include "../types.h"

namespace braidx {

/// Closest points of two segments p0-p1 and q0-q1: local coordinates in [0, 1] and distance in mm.
struct SegmentDistance {
    double t_a;
    double t_b;
    double distance;
};
SegmentDistance segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

} // namespace braidx
