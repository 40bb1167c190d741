#include "crossings.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

double middle_a(const Crossing& c) {
    return 0.5 * (c.low_a + c.high_a);
}
double middle_b(const Crossing& c) {
    return 0.5 * (c.low_b + c.high_b);
}

Vec3 middle(const TubePair& pair, double arc_a, double arc_b) {
    return 0.5 * (position(pair.a, pair.q, arc_a / pair.a.element_length) +
                  position(pair.b, pair.q, arc_b / pair.b.element_length));
}

/// Radial direction that the order asks for, made normal to the mean tangent: contact must not drag
/// nodes along.
Vec3 oriented_normal(const TubePair& pair, const Crossing& c, double arc_a, double arc_b) {
    const Vec3 ta = curve_point(pair.a, pair.q, arc_a / pair.a.element_length).tangent;
    const Vec3 tb = curve_point(pair.b, pair.q, arc_b / pair.b.element_length).tangent;
    const Vec3 along = (ta + pair.orientation * tb).normalized();
    const Vec3 radial = c.normal(middle(pair, arc_a, arc_b));
    const Vec3 across = radial - radial.dot(along) * along;
    return across.norm() > 0.1 ? across.normalized()
                               : radial; // yarns that run out radially keep it
}

/// The pair seen along the crossing's normal at rest arc lengths (mm).
TubePair seen_along_normal(const std::vector<Tube>& tubes, Unknowns q, const Crossing& c,
                           double arc_a, double arc_b) {
    const Tube &a = tubes[c.tube_a], &b = tubes[c.tube_b];
    const Vec3 ta = curve_point(a, q, arc_a / a.element_length).tangent;
    const Vec3 tb = curve_point(b, q, arc_b / b.element_length).tangent;
    TubePair pair{a, b, q, ta.dot(tb) >= 0 ? 1 : -1};
    const Vec3 normal = oriented_normal(pair, c, arc_a, arc_b);
    pair.metric -= normal * normal.transpose();
    return pair;
}

OrientedStation orient(const TubePair& pair, const Crossing& c, const Station& s) {
    const Vec3 normal =
        oriented_normal(pair, c, s.s_a * pair.a.element_length, s.s_b * pair.b.element_length);
    const Vec3 across = pair.across(s);
    const double touch = pair.a.radius + pair.b.radius;
    const double lateral = std::min(touch, (across - across.dot(normal) * normal).norm());
    return {s, normal, touch - std::sqrt((touch - lateral) * (touch + lateral))};
}

/// Where the centre lines cross, seen along the normal; the normal follows the place.
std::optional<Station> point_where_they_cross(const std::vector<Tube>& tubes, Unknowns q,
                                              const Crossing& c, double weight) {
    std::pair<double, double> arc{middle_a(c), middle_b(c)};
    for (int look = 0; look < 3; ++look) {
        const auto at =
            seen_along_normal(tubes, q, c, arc.first, arc.second).closest(arc.first, arc.second);
        if (!at || !c.contains(at->first, at->second))
            return std::nullopt;
        arc = *at;
    }
    return seen_along_normal(tubes, q, c, arc.first, arc.second)
        .station(arc.first, arc.second, weight, point_station);
}

/// Line stations in the windows; the half difference and the normal are followed from one to the
/// next.
std::vector<Station> stations_along(const std::vector<Tube>& tubes, Unknowns q, const Crossing& c,
                                    double spacing) {
    std::vector<Station> out;
    auto pair = seen_along_normal(tubes, q, c, middle_a(c), middle_b(c));
    const double o = pair.orientation;
    const double low = 0.5 * (c.low_a + std::min(o * c.low_b, o * c.high_b));
    const double high = 0.5 * (c.high_a + std::max(o * c.low_b, o * c.high_b));
    double half_difference = 0.5 * (middle_a(c) - o * middle_b(c));
    for (auto k = static_cast<std::int64_t>(std::floor(low / spacing)); k * spacing < high; ++k) {
        const double mean = (static_cast<double>(k) + 0.5) * spacing;
        const auto found = pair.facing(mean, half_difference);
        if (!found || !c.contains(mean + *found, o * (mean - *found)))
            continue;
        // Past the axis the other side of the rope faces: no business of this crossing.
        const Vec3 at_a = c.normal(position(pair.a, q, (mean + *found) / pair.a.element_length));
        const Vec3 at_b =
            c.normal(position(pair.b, q, o * (mean - *found) / pair.b.element_length));
        if (at_a.dot(at_b) < 0.85)
            continue;
        half_difference = *found;
        out.push_back(pair.station(mean + *found, o * (mean - *found), spacing, k));
    }
    return out;
}

} // namespace

std::vector<OrientedStation> crossing_stations(const std::vector<Tube>& tubes, Unknowns q,
                                               const Crossing& crossing, double spacing,
                                               const CrossingOptions& options) {
    const auto pair = seen_along_normal(tubes, q, crossing, middle_a(crossing), middle_b(crossing));
    const double touch = pair.a.radius + pair.b.radius;
    const auto beside = [&](const OrientedStation& s) {
        return s.allowance > touch * (1 - std::sqrt(1 - options.lateral * options.lateral));
    };
    const auto separated = [&](const OrientedStation& s) {
        return pair.across(s.station).dot(s.normal) > options.separation * (touch - s.allowance);
    };
    const auto point = point_where_they_cross(tubes, q, crossing, spacing);
    if (options.by_point) {
        if (!point)
            return {};
        // Most crossings are separated most of the time: they need no look at the other stations.
        const auto at_point = orient(pair, crossing, *point);
        if (beside(at_point) || separated(at_point))
            return {};
    }
    auto stations = stations_along(tubes, q, crossing, cell_length(pair.a, pair.b, spacing));
    if (point)
        stations.push_back(*point);
    std::vector<OrientedStation> out;
    for (const auto& s : stations)
        out.push_back(orient(pair, crossing, s));
    std::erase_if(out, beside);
    if (!options.by_point && std::ranges::all_of(out, separated))
        out.clear();
    return out;
}

std::optional<double> crossing_height(const std::vector<Tube>& tubes, Unknowns q,
                                      const Crossing& crossing) {
    const auto point = point_where_they_cross(tubes, q, crossing, 0);
    if (!point)
        return std::nullopt;
    const auto pair = seen_along_normal(tubes, q, crossing, middle_a(crossing), middle_b(crossing));
    return pair.across(*point).dot(orient(pair, crossing, *point).normal);
}

} // namespace braidx
