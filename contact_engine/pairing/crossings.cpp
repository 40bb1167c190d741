#include "crossings.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

double middle_a(const Crossing& c) { return 0.5 * (c.low_a + c.high_a); }
double middle_b(const Crossing& c) { return 0.5 * (c.low_b + c.high_b); }

TubePair seen_along_normal(const std::vector<Tube>& tubes, Unknowns q, const Crossing& c) {
    const Tube &a = tubes[c.tube_a], &b = tubes[c.tube_b];
    const Vec3 ta = curve_point(a, q, middle_a(c) / a.element_length).tangent;
    const Vec3 tb = curve_point(b, q, middle_b(c) / b.element_length).tangent;
    return {a, b, q, ta.dot(tb) >= 0 ? 1 : -1, Mat3::Identity() - c.normal * c.normal.transpose()};
}

std::optional<Station> point_where_they_cross(const TubePair& pair, const Crossing& c, double weight) {
    const auto at = pair.closest(middle_a(c), middle_b(c));
    if (!at || !c.contains(at->first, at->second))
        return std::nullopt;
    return pair.station(at->first, at->second, weight, point_station);
}

std::vector<Station> stations_along(const TubePair& pair, const Crossing& c, double spacing, double lateral) {
    std::vector<Station> out;
    const double o = pair.orientation;
    const double low = 0.5 * (c.low_a + std::min(o * c.low_b, o * c.high_b));
    const double high = 0.5 * (c.high_a + std::max(o * c.low_b, o * c.high_b));
    double half_difference = 0.5 * (middle_a(c) - o * middle_b(c));
    for (auto k = static_cast<std::int64_t>(std::floor(low / spacing)); k * spacing < high; ++k) {
        const double mean = (static_cast<double>(k) + 0.5) * spacing;
        const auto found = pair.facing(mean, half_difference);
        if (!found || !c.contains(mean + *found, o * (mean - *found)))
            continue;
        half_difference = *found;
        const Station s = pair.station(mean + *found, o * (mean - *found), spacing, k);
        if ((pair.metric * pair.across(s)).norm() < lateral)
            out.push_back(s);
    }
    return out;
}

} // namespace

std::vector<Station> crossing_stations(const std::vector<Tube>& tubes, Unknowns q, const Crossing& crossing,
                                       double spacing, const CrossingOptions& options) {
    const auto pair = seen_along_normal(tubes, q, crossing);
    const double touch = pair.a.radius + pair.b.radius;
    auto stations = stations_along(pair, crossing, spacing, options.lateral * touch);
    if (const auto point = point_where_they_cross(pair, crossing, spacing))
        stations.push_back(*point);
    const bool separated = std::ranges::all_of(stations, [&](const Station& s) {
        return pair.across(s).dot(crossing.normal) > options.separation * touch;
    });
    if (separated)
        stations.clear();
    return stations;
}

std::optional<double> crossing_height(const std::vector<Tube>& tubes, Unknowns q, const Crossing& crossing) {
    const auto pair = seen_along_normal(tubes, q, crossing);
    const auto point = point_where_they_cross(pair, crossing, 0);
    return point ? std::optional(pair.across(*point).dot(crossing.normal)) : std::nullopt;
}

} // namespace braidx
