#include "turn.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace braidx {
namespace {

/// Weight of the line between the centres of two tubes. It says how they turn about their mean
/// tangent where tangents do not, at angles of less than 8 degrees. Where they cross it is wrong
/// by what one slides across the other, which this keeps small.
constexpr double centre_line = 0.02;

Vec3 tangent(const Tube& tube, Unknowns q, double s) {
    return curve_point(tube, q, s).tangent.normalized();
}

/// What turns with a place on a facet: its normal and both tangents.
std::array<Turned, 3> facet_directions(const Skin& skin, std::int32_t facet, const double (&xi)[2],
                                       Unknowns before, Unknowns after) {
    const auto weights = facet_weights(skin.kind, xi[0], xi[1]);
    const auto from = facet_geometry(skin, before, facet, weights),
               to = facet_geometry(skin, after, facet, weights);
    return {Turned(from.area().normalized(), to.area().normalized()),
            Turned(from.du.normalized(), to.du.normalized()),
            Turned(from.dv.normalized(), to.dv.normalized())};
}

Mat3 turn_of_tubes(const Tube& a, const Tube& b, const ContactElement& e, Unknowns before,
                   Unknowns after) {
    const Vec3 a0 = tangent(a, before, e.s_a), a1 = tangent(a, after, e.s_a);
    const Vec3 b0 = tangent(b, before, e.s_b), b1 = tangent(b, after, e.s_b);
    const double o = a1.dot(b1) < 0 ? -1 : 1; // whether they run the same way
    const auto across = [&](Unknowns q) -> Vec3 {
        return std::sqrt(centre_line) / (a.radius + b.radius) *
               (position(b, q, e.s_b) - position(a, q, e.s_a));
    };
    return rotation_of(
        {a0 + o * b0, a1 + o * b1},
        std::array{Turned(a0 - o * b0, a1 - o * b1), Turned(across(before), across(after))});
}

} // namespace

Mat3 rotation_of(const Turned& axis, std::span<const Turned> others) {
    const auto tilt = Eigen::Quaterniond::FromTwoVectors(axis.first, axis.second);
    const Vec3 about = axis.second.normalized();
    double sine = 0, cosine = 0;
    for (const auto& [before, after] : others) {
        const Vec3 tilted = tilt * before;
        sine += about.dot(tilted.cross(after));
        cosine += tilted.dot(after) - tilted.dot(about) * after.dot(about);
    }
    return (Eigen::AngleAxisd(std::atan2(sine, cosine), about) * tilt).toRotationMatrix();
}

Mat3 turn_of(const DeformableSurfaces& surfaces, const ContactElement& e, Unknowns before,
             Unknowns after, const Mat3& rigid) {
    if (e.facet_a >= 0) {
        const auto [normal, along_u, along_v] =
            facet_directions(surfaces.skin(e.surface_a), e.facet_a, e.xi_a, before, after);
        return rotation_of(normal, std::array{along_u, along_v});
    }
    const Tube& a = surfaces.tube(e.surface_a);
    const Turned axis(tangent(a, before, e.s_a), tangent(a, after, e.s_a));
    if (against_rigid(e))
        return rotation_of(axis, std::array{Turned(Vec3::UnitX(), rigid.col(0)),
                                            Turned(Vec3::UnitY(), rigid.col(1)),
                                            Turned(Vec3::UnitZ(), rigid.col(2))});
    if (e.facet_b >= 0)
        return rotation_of(
            axis, facet_directions(surfaces.skin(e.surface_b), e.facet_b, e.xi_b, before, after));
    return turn_of_tubes(a, surfaces.tube(e.surface_b), e, before, after);
}

} // namespace braidx
