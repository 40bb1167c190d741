#include "builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

/// Surface particle of a tube that faces `direction`, in section coordinates (beams only).
void face(const Tube& tube, Unknowns q, double s, const Vec3& direction, double (&xi)[2]) {
    if (!tube.has_directors())
        return;
    const auto support = element_support(tube, s);
    const double c1 = director(tube, q, support, 1).dot(direction),
                 c2 = director(tube, q, support, 2).dot(direction);
    const double norm = std::max(std::hypot(c1, c2), 1e-12);
    xi[0] = tube.radius * c1 / norm;
    xi[1] = tube.radius * c2 / norm;
}

} // namespace

ContactElements Builder::zone(const ProximityZone& zone,
                              const std::vector<Station>& stations) const {
    const auto a = zone.tube_a, b = zone.tube_b;
    const auto movable = [&](std::int32_t t, double s) {
        return s > surfaces_.tube(t).first_element() && s < surfaces_.tube(t).end_element() &&
               (surfaces_.tube(t).smooth || surfaces_.tube(t).degree == 2);
    };
    ContactElements out;
    for (const auto& s : stations) {
        const int follows = movable(a, s.s_a) && movable(b, s.s_b) ? zone.orientation : 0;
        out.push_back({.surface_a = a,
                       .surface_b = b,
                       .s_a = s.s_a,
                       .s_b = s.s_b,
                       .station = s.index,
                       .normal = centre_to_centre(a, b, s),
                       .follows = follows,
                       .weight = s.weight,
                       .stiffness = 0});
    }
    return finished(std::move(out));
}

ContactElements Builder::wall(std::int32_t a, const Rigid& rigid, std::int32_t number) const {
    const Tube& tube = surfaces_.tube(a);
    ContactElements out;
    const auto count = static_cast<std::int64_t>(std::ceil(tube.length() / options_.spacing));
    const double spacing = tube.length() / static_cast<double>(count);
    for (std::int64_t k = 0; k < count; ++k) {
        const double s = (static_cast<double>(k) + 0.5) * spacing / tube.element_length;
        const Vec3 x = position(tube, q_, s);
        const auto wall = rigid.nearest(x);
        if ((x - wall.position).dot(wall.normal) > tube.radius + options_.search.margin)
            continue;
        out.push_back({.surface_a = a,
                       .surface_b = -1 - number,
                       .body_b = rigid.body,
                       .s_a = s,
                       .s_b = 0,
                       .station = k,
                       .normal = -wall.normal,
                       .weight = spacing,
                       .stiffness = 0,
                       .wall = wall.position,
                       .wall_start = rigid.at_start(wall.position)});
    }
    return finished(std::move(out));
}

ContactElements Builder::crossing(const Crossing& crossing, std::int32_t number,
                                  const std::vector<OrientedStation>& stations) const {
    ContactElements out;
    for (const auto& [s, normal, allowance] : stations) {
        if (!is_kept(surfaces_.tube(crossing.tube_a), surfaces_.tube(crossing.tube_b), s))
            continue;
        out.push_back({.surface_a = crossing.tube_a,
                       .surface_b = crossing.tube_b,
                       .s_a = s.s_a,
                       .s_b = s.s_b,
                       .station = s.index,
                       .normal = normal,
                       .weight = s.weight,
                       .stiffness = 0,
                       .allowance = allowance,
                       .crossing = number});
    }
    return finished(std::move(out));
}

ContactElements Builder::finished(ContactElements elements) const {
    for (auto& e : elements)
        e = complete(e);
    share_stiffness(elements);
    return elements;
}

/// The element with its memory, and the surface particles of beams.
ContactElement Builder::complete(ContactElement e) const {
    if (const auto* old = history_.predecessor(e, 4 * options_.spacing))
        inherit(e, *old, options_.keep_side);
    if (e.facet_a < 0)
        face(surfaces_.tube(e.surface_a), q_, e.s_a, e.normal, e.xi_a);
    if (against_rigid(e))
        return e;
    if (e.facet_b < 0)
        face(surfaces_.tube(e.surface_b), q_, e.s_b, -e.normal, e.xi_b);
    e.body_b = surfaces_.body(e.surface_b);
    return e;
}

Vec3 Builder::centre_to_centre(std::int32_t a, std::int32_t b, const Station& s) const {
    const Vec3 d = position(surfaces_.tube(b), q_, s.s_b) - position(surfaces_.tube(a), q_, s.s_a);
    const double length = d.norm();
    if (length > 1e-9 * surfaces_.tube(a).radius)
        return d / length;
    const Vec3 t =
        curve_point(surfaces_.tube(a), q_, s.s_a).tangent; // coinciding centres: any normal will do
    return t.unitOrthogonal();
}

void Builder::share_stiffness(ContactElements& elements) const {
    double stiffness = 0;
    for (const auto& e : elements)
        stiffness = std::max(stiffness, e.stiffness);
    for (auto& e : elements)
        e.stiffness = stiffness > 0    ? stiffness
                      : is_per_area(e) ? options_.area_stiffness
                                       : options_.stiffness;
}

} // namespace braidx
