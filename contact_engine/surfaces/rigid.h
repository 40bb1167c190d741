#pragma once

#include "../types.h"

#include <variant>

namespace braidx {

/// Nearest point of a rigid surface, and the unit normal there that points out of the solid.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;
};

/// Half space below a plane.
struct Plane {
    Vec3 point;
    Vec3 normal; ///< unit, out of the solid

    SurfacePoint nearest(const Vec3& x) const;
};

/// Solid round bar, or (hollow) a bore through a solid: a braiding die, a core, a drum.
struct Cylinder {
    Vec3 point;
    Vec3 axis;     ///< unit
    double radius; ///< mm
    bool hollow;

    SurfacePoint nearest(const Vec3& x) const;
};

/// Sheave: a disc with a round groove of radius groove_radius, centred on a circle of radius
/// `radius` about the axis; outside that circle the groove is open between two plane flanks.
struct Sheave {
    Vec3 centre;
    Vec3 axis;            ///< unit
    double radius;        ///< of the circle of groove centres, mm
    double groove_radius; ///< mm

    SurfacePoint nearest(const Vec3& x) const;
};

/// A rigid surface with its motion during the increment.
struct Rigid {
    std::variant<Plane, Cylinder, Sheave> shape;
    int body; ///< number of the body, for friction per pair of bodies
    Vec3 pivot = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();    ///< of the increment about the pivot: axis times angle, rad
    Vec3 translation = Vec3::Zero(); ///< of the increment, mm

    SurfacePoint nearest(const Vec3& x) const;

    /// Rotation of the increment.
    Mat3 turn() const;

    /// Where a particle of the surface, now at x, was when the increment started.
    Vec3 at_start(const Vec3& x) const;
};

} // namespace braidx
