#include "rigid.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

namespace braidx {
namespace {

/// Unit vector along v, or `otherwise` where v vanishes (mm, up to round-off).
Vec3 direction(const Vec3& v, const Vec3& otherwise) {
    const double length = v.norm();
    return length > 1e-9 ? Vec3(v / length) : otherwise;
}

Mat3 directors(Unknowns q, std::int64_t frame) {
    Mat3 out;
    for (int i = 0; i < 3; ++i)
        out.col(i) = vector_at(q, frame + 3 * (i + 1));
    return out;
}

Vec3 across(const Vec3& v, const Vec3& axis) {
    return v - v.dot(axis) * axis;
}

} // namespace

SurfacePoint Plane::nearest(const Vec3& x) const {
    return {x - (x - point).dot(normal) * normal, normal};
}

SurfacePoint Cylinder::nearest(const Vec3& x) const {
    const Vec3 off = across(x - point, axis);
    const Vec3 radial = direction(off, axis.unitOrthogonal());
    return {x - off + radius * radial, hollow ? Vec3(-radial) : radial};
}

SurfacePoint Sheave::nearest(const Vec3& x) const {
    const Vec3 off = across(x - centre, axis);
    // Beyond the circle of groove centres the flanks run on, so that a rope can leave along the
    // tangent.
    const Vec3 groove_centre =
        centre + std::max(radius, off.norm()) * direction(off, axis.unitOrthogonal());
    const Vec3 inward = direction(x - groove_centre, axis);
    return {groove_centre + groove_radius * inward, -inward};
}

SurfacePoint Rigid::nearest(const Vec3& x) const {
    return std::visit([&](const auto& s) { return s.nearest(x); }, shape);
}

Vec3 Rigid::in_frame(const Vec3& x, Unknowns q) const {
    return directors(q, frame).inverse() * (x - vector_at(q, frame));
}

Mat3 Rigid::turn(Unknowns q_start, Unknowns q) const {
    if (frame >= 0)
        return directors(q, frame) * directors(q_start, frame).inverse();
    const double angle = rotation.norm();
    if (angle == 0)
        return Mat3::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

Vec3 Rigid::at_start(const Vec3& x, Unknowns q_start, Unknowns q) const {
    if (frame >= 0)
        return vector_at(q_start, frame) + directors(q_start, frame) * in_frame(x, q);
    return pivot + turn(q_start, q).transpose() * (x - translation - pivot);
}

} // namespace braidx
