#include "tube.h"

#include <utility>

namespace braidx {
namespace {

Support linear_support(std::int32_t e, double t) {
    Support out;
    out.count = 2;
    out.node = {e, e + 1};
    out.weight = {1.0 - t, t};
    out.slope = {-1.0, 1.0};
    return out;
}

Support quadratic_support(std::int32_t e, double t) {
    Support out;
    out.count = 3;
    out.node = {2 * e, 2 * e + 1, 2 * e + 2};
    out.weight = {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
    out.slope = {4 * t - 3, 4 - 8 * t, 4 * t - 1};
    out.bend = {4, -8, 4};
    return out;
}

/// Catmull-Rom weights. The phantom node past the end of a rod continues the parabola through the
/// last three nodes, which the last element then is. Of a tube that goes on beyond what is
/// modelled, it continues the straight line; a tube of one element is one.
Support smooth_support(const Tube& tube, double s) {
    const auto e = tube.element_of(s);
    const double t = s - e;
    std::array<double, 4> w = {t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (-2.5 + 1.5 * t),
                               t * (0.5 + t * (2.0 - 1.5 * t)), t * t * (-0.5 + 0.5 * t)};
    std::array<double, 4> d = {-0.5 + t * (2.0 - 1.5 * t), t * (-5.0 + 4.5 * t),
                               0.5 + t * (4.0 - 4.5 * t), t * (-1.0 + 1.5 * t)};
    std::array<double, 4> b = {2.0 - 3.0 * t, -5.0 + 9.0 * t, 4.0 - 9.0 * t, -1.0 + 3.0 * t};
    const bool first = !tube.is_closed && e == tube.first_element(),
               last = !tube.is_closed && e == tube.end_element() - 1;
    if (first && last)
        return linear_support(e, t);
    const auto fold = [&](int phantom, int inward) {
        const double bend = tube.has_ends() ? 1.0 : 0.0;
        for (auto* v : {&w, &d, &b}) {
            const double folded = std::exchange((*v)[phantom], 0.0);
            (*v)[phantom + inward] += (2.0 + bend) * folded;
            (*v)[phantom + 2 * inward] -= (1.0 + 2.0 * bend) * folded;
            (*v)[phantom + 3 * inward] += bend * folded;
        }
    };
    if (first)
        fold(0, 1);
    if (last)
        fold(3, -1);
    Support out;
    for (int i = first ? 1 : 0; i < (last ? 3 : 4); ++i) {
        out.node[out.count] = e - 1 + i;
        out.weight[out.count] = w[i];
        out.slope[out.count] = d[i];
        out.bend[out.count] = b[i];
        ++out.count;
    }
    return out;
}

/// Weighted sum of positions.
Vec3 combined(const Tube& tube, Unknowns q, const Support& support) {
    Vec3 x = Vec3::Zero();
    for (int i = 0; i < support.count; ++i)
        x += support.weight[i] * vector_at(q, tube.unknown_of(support.node[i]));
    return x;
}

} // namespace

Support element_support(const Tube& tube, double s) {
    const auto e = tube.element_of(s);
    return tube.degree == 1 ? linear_support(e, s - e) : quadratic_support(e, s - e);
}

Support contact_support(const Tube& tube, double s) {
    if (tube.degree != 1 || !tube.smooth)
        return element_support(tube, s);
    return smooth_support(tube, s);
}

Vec3 position(const Tube& tube, Unknowns q, double s) {
    return combined(tube, q, contact_support(tube, s));
}

CurvePoint curve_point(const Tube& tube, Unknowns q, double s) {
    // Tangents of degree-1 curves are always the smooth ones: those of the polygon jump at its
    // nodes.
    const Support slope = tube.degree == 1 ? smooth_support(tube, s) : element_support(tube, s);
    CurvePoint out{combined(tube, q, tube.is_polygon() ? element_support(tube, s) : slope),
                   Vec3::Zero()};
    for (int i = 0; i < slope.count; ++i)
        out.tangent += slope.slope[i] * vector_at(q, tube.unknown_of(slope.node[i]));
    out.tangent /= tube.element_length;
    return out;
}

Vec3 curve_bend(const Tube& tube, Unknowns q, double s) {
    const Support support = contact_support(tube, s);
    Vec3 bend = Vec3::Zero();
    for (int i = 0; i < support.count; ++i)
        bend += support.bend[i] * vector_at(q, tube.unknown_of(support.node[i]));
    return bend / (tube.element_length * tube.element_length);
}

int end_at(const Tube& tube, double s) {
    if (!tube.has_ends())
        return 0;
    return s <= tube.first_element() ? -1 : s >= tube.end_element() ? 1 : 0;
}

double lean(const Tube& tube, Unknowns q, double s, const Vec3& direction) {
    const int end = end_at(tube, s);
    if (end == 0)
        return 0;
    return end * curve_point(tube, q, s).tangent.normalized().dot(direction.normalized());
}

Vec3 director(const Tube& tube, Unknowns q, const Support& support, int which) {
    Vec3 g = Vec3::Zero();
    for (int i = 0; i < support.count; ++i)
        g += support.weight[i] * vector_at(q, tube.unknown_of(support.node[i]) + 3 * which);
    return g;
}

} // namespace braidx
