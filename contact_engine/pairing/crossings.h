#pragma once

#include "stations.h"

#include <Eigen/Geometry>

namespace braidx {

/// A crossing of two tubes whose stacking order is prescribed (paper 1, 3.2 and 3.4.2): stretches
/// of rest arc length (mm) where they meet, and which of them lies outside, seen from the rope's
/// axis.
struct Crossing {
    std::int32_t tube_a, tube_b;
    double low_a, high_a;
    double low_b, high_b;
    int order;           ///< +1: a outside b; -1: b outside a
    Vec3 axis_point;     ///< of the rope's axis, mm
    Vec3 axis_direction; ///< unit

    /// Direction from a to b that the order asks for, at a place x: radial, whatever the yarns do
    /// there.
    Vec3 normal(const Vec3& x) const {
        Vec3 radial = x - axis_point;
        radial -= radial.dot(axis_direction) * axis_direction;
        const double length = radial.norm();
        return length > 0 ? Vec3(-order / length * radial) : axis_direction.unitOrthogonal();
    }

    bool contains(double arc_a, double arc_b) const {
        return arc_a >= low_a && arc_a <= high_a && arc_b >= low_b && arc_b <= high_b;
    }
};

/// When a crossing counts as separated, and which stations act while it is not. Factors of radius_a
/// + radius_b.
struct CrossingOptions {
    double separation = 0.7; ///< separated where the distance along the normal exceeds this
    double lateral =
        0.9; ///< a station acts where the centre lines, seen along the normal, are nearer than this
    bool by_point =
        false; ///< judge separation only where the centre lines cross, seen along the normal
};

/// A station of a crossing that is not separated yet.
struct OrientedStation {
    Station station;
    Vec3 normal;      ///< from a to b
    double allowance; ///< tubes seen `lateral` apart touch when the centres are this much closer
                      ///< than the radii, mm
};

/// Stations of a crossing that is not separated yet, seen along its normal; none once it is
/// separated.
std::vector<OrientedStation> crossing_stations(const std::vector<Tube>& tubes, Unknowns q,
                                               const Crossing& crossing, double spacing,
                                               const CrossingOptions& options);

/// Signed distance of b above a along the normal where the centre lines cross, seen along the
/// normal (mm); nothing where they do not cross in the windows.
std::optional<double> crossing_height(const std::vector<Tube>& tubes, Unknowns q,
                                      const Crossing& crossing);

} // namespace braidx
