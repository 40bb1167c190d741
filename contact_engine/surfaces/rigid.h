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

/// A rigid surface with its motion during the increment: prescribed, or that of a frame among the
/// unknowns.
///
/// A frame is twelve unknowns, a point x and three directors. A particle at x + xi1 g1 + xi2 g2 +
/// xi3 g3 is then linear in the unknowns however far the frame turns. The shape stays where it is,
/// so that a frame may only turn it about an axis of revolution.
struct Rigid {
    std::variant<Plane, Cylinder, Sheave> shape;
    int body; ///< number of the body, for friction per pair of bodies
    Vec3 pivot = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();    ///< of the increment about the pivot: axis times angle, rad
    Vec3 translation = Vec3::Zero(); ///< of the increment, mm

    std::int64_t frame = -1; ///< its first unknown, -1: the motion is prescribed

    static constexpr int frame_vectors = 4;

    SurfacePoint nearest(const Vec3& x) const;

    /// Coordinates in the frame of a particle that is now at x.
    Vec3 in_frame(const Vec3& x, Unknowns q) const;

    /// Rotation of the increment.
    Mat3 turn(Unknowns q_start, Unknowns q) const;

    /// Where a particle of the surface, now at x, was when the increment started.
    Vec3 at_start(const Vec3& x, Unknowns q_start, Unknowns q) const;
};

} // namespace braidx
