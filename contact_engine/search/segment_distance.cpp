#include "segment_distance.h"

#include <algorithm>
#include <cmath>

namespace braidx {

SegmentDistance segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    const Vec3 u = p1 - p0, v = q1 - q0, w = q0 - p0;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
    const double uw = u.dot(w), vw = v.dot(w);
    const double det = uu * vv - uv * uv;
    // Minimise |w + t_b v - t_a u|; parallel segments take t_a = 1/2 as a start.
    double t_a = det > 1e-12 * uu * vv ? std::clamp((uw * vv - vw * uv) / det, 0.0, 1.0) : 0.5;
    const double free_b = vv > 0 ? (t_a * uv - vw) / vv : 0;
    const double t_b = std::clamp(free_b, 0.0, 1.0);
    if (t_b != free_b || det <= 1e-12 * uu * vv)
        t_a = uu > 0 ? std::clamp((uw + t_b * uv) / uu, 0.0, 1.0) : 0;
    return {t_a, t_b, (w + t_b * v - t_a * u).norm()};
}

} // namespace braidx
