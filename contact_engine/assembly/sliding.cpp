#include "sliding.h"

#include "../pairing/stations.h"

namespace braidx {
namespace {

/// Adds weights and slopes (per mm) of a side's centre line to the places of its unknowns.
void add_side(const Tube& tube, double s, double sign, const LocalSystem& system,
              LocalSystem::Weights& centre, LocalSystem::Weights& slope) {
    const Support support = contact_support(tube, s);
    for (int i = 0; i < support.count; ++i) {
        const int at = system.find(tube.unknown_of(support.node[i]));
        centre[at] = sign * support.weight[i];
        slope[at] = support.slope[i] / tube.element_length;
    }
}

} // namespace

Sliding::Sliding(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns q,
                 const LocalSystem& system) {
    const Tube &a = surfaces.tube(element.surface_a), &b = surfaces.tube(element.surface_b);
    const Facing& at = system.facing;
    add_side(a, at.s_a, -1, system, centre_, slope_a_);
    add_side(b, at.s_b, 1, system, centre_, slope_b_);
    normal_ = at.normal;
    tangent_a_ = curve_point(a, q, at.s_a).tangent;
    tangent_b_ = curve_point(b, q, at.s_b).tangent;
    turn_ = (at.side / at.distance) * (Mat3::Identity() - normal_ * normal_.transpose());
    const Vec3 d = at.side * at.distance * normal_;
    const Vec3 bend_a = curve_bend(a, q, at.s_a), bend_b = curve_bend(b, q, at.s_b);
    if (element.station == point_station) {
        for (int i = 0; i < system.count; ++i) {
            row_a_[i] = centre_[i] * tangent_a_ + slope_a_[i] * d;
            row_b_[i] = centre_[i] * tangent_b_ + slope_b_[i] * d;
        }
        solve(system.count, tangent_a_.squaredNorm() - d.dot(bend_a), tangent_a_.dot(tangent_b_),
              tangent_b_.squaredNorm() + d.dot(bend_b));
        return;
    }
    const double o = element.follows;
    const Vec3 mean = tangent_a_ + o * tangent_b_;
    const double stiffness = mean.squaredNorm() - d.dot(bend_a - bend_b);
    for (int i = 0; i < system.count; ++i) {
        row_a_[i] = (centre_[i] * mean + (slope_a_[i] + o * slope_b_[i]) * d) / stiffness;
        row_b_[i] = -o * row_a_[i];
    }
}

/// Solves aa da - ab db = row_a, ab da - bb db = row_b for the motions of the sections of a point
/// element.
void Sliding::solve(int count, double aa, double ab, double bb) {
    const double determinant = ab * ab - aa * bb;
    for (int i = 0; i < count; ++i) {
        const Vec3 first = row_a_[i], second = row_b_[i];
        row_a_[i] = (ab * second - bb * first) / determinant;
        row_b_[i] = (aa * second - ab * first) / determinant;
    }
}

Mat3 Sliding::block(int i, int j) const {
    Mat3 moved = tangent_b_ * row_b_[j].transpose() - tangent_a_ * row_a_[j].transpose();
    moved.diagonal().array() += centre_[j];
    return centre_[i] * (turn_ * moved) +
           normal_ * (slope_b_[i] * row_b_[j] - slope_a_[i] * row_a_[j]).transpose();
}

} // namespace braidx
