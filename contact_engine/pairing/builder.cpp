#include "builder.h"

#include "end_stations.h"
#include "turn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace braidx {
namespace {

/// Section coordinates of the particle of a beam that faces a direction: its directors' components.
struct FacingParticle {
    double c1, c2, norm;

    /// `round`: of an end, see ContactElement; its particles are those of the section below the
    /// half sphere.
    FacingParticle(const Tube& tube, Unknowns q, double s, const Vec3& direction, double round) {
        const auto support = element_support(tube, s);
        c1 = director(tube, q, support, 1).dot(direction);
        c2 = director(tube, q, support, 2).dot(direction);
        const double in_section = std::sqrt(1 - round);
        norm = in_section > 1e-6 ? std::max(std::hypot(c1, c2) / in_section, 1e-12) : 1;
    }

    /// At the surface but for `inside`, mm along the direction.
    void place(double radius, double inside, double (&xi)[2]) const {
        const double out = std::clamp(radius - inside / norm, 0.0, 2 * radius) / norm;
        xi[0] = out * c1;
        xi[1] = out * c2;
    }
};

/// How far the surface particle that faces a direction is out along it, mm.
double reach(const Tube& tube, Unknowns q, double s, const Vec3& direction, double round) {
    return tube.has_directors() ? tube.radius * FacingParticle(tube, q, s, direction, round).norm
                                : tube.radius;
}

/// Places the particle of a beam that faces a direction; cables have theirs in their centre.
void face(const Tube& tube, Unknowns q, double s, const Vec3& direction, double round,
          double inside, double (&xi)[2]) {
    if (tube.has_directors())
        FacingParticle(tube, q, s, direction, round).place(tube.radius, inside, xi);
}

/// Where stations stand at a wall, s, and the length that each of them counts for, mm.
struct WallStations {
    std::vector<double> places;
    double weight;
};

/// Lets the ends of a tube stand there, too.
WallStations with_ends(const Tube& tube, WallStations stations) {
    if (tube.has_ends()) {
        stations.places.push_back(tube.first_element());
        stations.places.push_back(tube.end_element());
    }
    return stations;
}

/// In the middles of cells that divide a tube evenly.
WallStations middles(const Tube& tube, double spacing) {
    const auto count = static_cast<std::int64_t>(std::ceil(tube.length() / spacing));
    const double cell = tube.length() / static_cast<double>(count);
    std::vector<double> places;
    for (std::int64_t k = 0; k < count; ++k)
        places.push_back((static_cast<double>(k) + 0.5) * cell / tube.element_length);
    return {std::move(places), cell};
}

/// At the two points of Gauss of cells that divide elements evenly: the nodes of an element share a
/// load that varies along it as its shape functions say. Half as many as middles do better, but for
/// the two that an element needs.
WallStations gauss_points(const Tube& tube, double spacing) {
    constexpr double longer = 0.1; // share of a spacing that stations may be farther apart
    const auto cells = std::max(1.0, std::ceil(0.25 * (tube.element_length / spacing - longer)));
    std::vector<double> places;
    for (double k = 0; k < cells * tube.num_elements; ++k)
        for (const double side : {-1.0, 1.0})
            places.push_back((k + 0.5 * (1 + side * std::numbers::inv_sqrt3)) / cells);
    return {std::move(places), 0.5 * tube.element_length / cells};
}

/// Elements of degree 1 touch along curves through four nodes, which even loads out.
WallStations wall_stations(const Tube& tube, double spacing) {
    return tube.degree == 1 ? middles(tube, spacing) : gauss_points(tube, spacing);
}

} // namespace

ContactElements Builder::zone(const ProximityZone& zone,
                              const std::vector<Station>& stations) const {
    const auto a = zone.tube_a, b = zone.tube_b;
    const auto movable = [&](std::int32_t t, double s) {
        const Tube& tube = surfaces_.tube(t);
        return (tube.is_closed || (s > tube.first() && s < tube.end())) &&
               (tube.smooth || tube.degree == 2);
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
    const auto stations = with_ends(tube, wall_stations(tube, options_.spacing));
    for (std::int64_t k = 0; k < std::ssize(stations.places); ++k) {
        const double s = stations.places[k];
        const Vec3 x = position(tube, q_, s);
        const auto wall = rigid.nearest(x);
        if ((x - wall.position).dot(wall.normal) > tube.radius + options_.search.margin)
            continue;
        const double weight =
            weight_at(tube, q_, s, -wall.normal, stations.weight, options_.point_tolerance);
        if (weight == 0)
            continue;
        out.push_back({.surface_a = a,
                       .surface_b = -1 - number,
                       .body_b = rigid.body,
                       .s_a = s,
                       .s_b = 0,
                       .station = k,
                       .normal = -wall.normal,
                       .weight = weight,
                       .stiffness = 0,
                       .wall = wall.position});
    }
    return finished(std::move(out), rigid);
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

ContactElements Builder::finished(ContactElements elements, const Mat3& rigid) const {
    for (auto& e : elements)
        e = complete(e, rigid);
    share_stiffness(elements);
    return elements;
}

ContactElements Builder::finished(ContactElements elements, const Rigid& rigid) const {
    for (auto& e : elements) {
        e.wall_start = rigid.at_start(e.wall, q_start_, q_);
        e.frame = rigid.frame;
        if (rigid.frame >= 0)
            e.in_frame = rigid.in_frame(e.wall, q_);
    }
    return finished(std::move(elements), rigid.turn(q_start_, q_));
}

/// The element with how it has turned, its memory, and its particles.
ContactElement Builder::complete(ContactElement e, const Mat3& rigid) const {
    const auto* old = history_.predecessor(e, 4 * options_.spacing);
    e.turn = old && options_.within_increment && has_cable(e)
                 ? old->turn
                 : turn_of(surfaces_, e, q_start_, q_, rigid);
    if (old)
        inherit(e, *old, options_.keep_side);
    if (!against_rigid(e))
        e.body_b = surfaces_.body(e.surface_b);
    if (e.facet_a < 0) {
        round_ends(e);
        place_particles(e);
    }
    return e;
}

/// How far the normal runs along the axes of sections at ends.
void Builder::round_ends(ContactElement& e) const {
    const auto round = [&](std::int32_t surface, double s) {
        const Tube& tube = surfaces_.tube(surface);
        if (end_at(tube, s) == 0)
            return 0.0;
        Vec3 axis = curve_point(tube, q_, s).tangent;
        if (tube.has_directors()) {
            const auto section = element_support(tube, s);
            axis = director(tube, q_, section, 1).cross(director(tube, q_, section, 2));
        }
        const double cosine = axis.normalized().dot(e.normal);
        return std::min(1.0, cosine * cosine);
    };
    e.round_a = round(e.surface_a, e.s_a);
    if (!against_rigid(e) && e.facet_b < 0)
        e.round_b = round(e.surface_b, e.s_b);
}

/// Whether a particle is in the centre of a cable. It would take any rotation found while the
/// equilibrium is being sought for slip, one or two radii times the angle, but friction does not
/// act on the tangents that the rotation is found from: that repetition does not converge.
bool Builder::has_cable(const ContactElement& e) const {
    const auto is_cable = [&](std::int32_t surface, std::int32_t facet) {
        return facet < 0 && !surfaces_.tube(surface).has_directors();
    };
    return is_cable(e.surface_a, e.facet_a) ||
           (!against_rigid(e) && is_cable(e.surface_b, e.facet_b));
}

/// Particles of a tube a and of b, on which friction acts. Those of beams are at one point: where
/// surfaces penetrate, midway between them, or on that of a skin or a rigid b, whose particles stay
/// on it. Forces at two points would leave a couple.
void Builder::place_particles(ContactElement& e) const {
    const Tube& a = surfaces_.tube(e.surface_a);
    const Vec3 x_a = position(a, q_, e.s_a);
    double depth = e.normal.dot(x_a) + reach(a, q_, e.s_a, e.normal, e.round_a);
    if (against_rigid(e)) {
        depth -= e.normal.dot(e.wall);
    } else if (e.facet_b >= 0) {
        const Skin& skin = surfaces_.skin(e.surface_b);
        const auto weights = facet_weights(skin.kind, e.xi_b[0], e.xi_b[1]);
        depth -= e.normal.dot(combined(skin, q_, e.facet_b, weights.value));
    } else {
        const Tube& b = surfaces_.tube(e.surface_b);
        depth += reach(b, q_, e.s_b, e.normal, e.round_b) - e.normal.dot(position(b, q_, e.s_b));
        depth *= 0.5;
        face(b, q_, e.s_b, -e.normal, e.round_b, depth, e.xi_b);
    }
    face(a, q_, e.s_a, e.normal, e.round_a, depth, e.xi_a);
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
