#include "rigid.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace braidx {
namespace {

/// Unit vector along v, or `otherwise` where v vanishes (mm, up to round-off).
Vec3 direction(const Vec3& v, const Vec3& otherwise) {
    const double length = v.norm();
    return length > 1e-9 ? Vec3(v / length) : otherwise;
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

Mat3 Rigid::turn() const {
    const double angle = rotation.norm();
    if (angle == 0)
        return Mat3::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

Vec3 Rigid::at_start(const Vec3& x) const {
    return pivot + turn().transpose() * (x - translation - pivot);
}

} // namespace braidx
