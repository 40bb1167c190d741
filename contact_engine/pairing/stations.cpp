#include "stations.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace braidx {
namespace {

/// Curve point at a rest arc length (mm). Past its ends a curve goes on straight, so that the cell
/// in which a tube ends is cut at the section of the other tube that faces the end.
CurvePoint extended_point(const Tube& tube, Unknowns q, double arc) {
    const double s = tube.inside(arc / tube.element_length), inside = s * tube.element_length;
    auto out = curve_point(tube, q, s);
    out.position += (arc - inside) * out.tangent;
    return out;
}

} // namespace

std::optional<double> TubePair::facing(double mean, double half_difference) const {
    const double o = orientation;
    for (int iteration = 0; iteration < 12; ++iteration) {
        const auto pa = extended_point(a, q, mean + half_difference);
        const auto pb = extended_point(b, q, o * (mean - half_difference));
        const Vec3 direction = metric * (pa.tangent + o * pb.tangent);
        const double length2 = direction.squaredNorm();
        if (length2 < 1e-4)
            return std::nullopt;
        const double step = (pb.position - pa.position).dot(direction) / length2;
        half_difference += std::clamp(step, -a.element_length, a.element_length);
        if (std::abs(step) < 1e-10 * a.element_length)
            return half_difference;
    }
    return half_difference; // kinks of polygons keep the last digits moving: harmless for a station
}

std::optional<std::pair<double, double>> TubePair::closest(double arc_a, double arc_b) const {
    const auto inside = [](const Tube& tube, double arc) {
        return tube.is_closed || (arc >= tube.low() && arc <= tube.high());
    };
    std::optional<std::pair<double, double>> best;
    double best_distance = std::numeric_limits<double>::infinity();
    double net_a = 0, net_b = 0,
           path = 0; // of the last steps: where they lead, and how far they go
    const double limit = std::min(a.element_length, b.element_length);
    for (int iteration = 0; iteration < 30; ++iteration) {
        if (!inside(a, arc_a) || !inside(b, arc_b))
            return std::nullopt;
        const auto pa = curve_point(a, q, arc_a / a.element_length);
        const auto pb = curve_point(b, q, arc_b / b.element_length);
        const Vec3 ta = metric * pa.tangent, tb = metric * pb.tangent,
                   d = pb.position - pa.position;
        const double aa = ta.squaredNorm(), bb = tb.squaredNorm(), ab = ta.dot(tb);
        if (const double distance = (metric * d).norm(); distance < best_distance) {
            best_distance = distance;
            best = {arc_a, arc_b};
        }
        // Full Newton where the distance is convex; seen along a direction it vanishes, and
        // curvature does not matter.
        double haa = aa, hbb = bb;
        if (metric.isIdentity()) {
            haa -= d.dot(curve_bend(a, q, arc_a / a.element_length));
            hbb += d.dot(curve_bend(b, q, arc_b / b.element_length));
        }
        if (haa <= 0 || haa * hbb - ab * ab < 1e-6 * aa * bb) {
            haa = aa;
            hbb = bb;
        }
        const double det = haa * hbb - ab * ab;
        if (det < 1e-6 * aa * bb)
            return std::nullopt;
        const double da = ta.dot(d), db = tb.dot(d);
        const double step_a = std::clamp((da * hbb - db * ab) / det, -limit, limit);
        const double step_b = std::clamp((da * ab - db * haa) / det, -limit, limit);
        arc_a += step_a;
        arc_b += step_b;
        const double moved = std::abs(step_a) + std::abs(step_b);
        if (iteration >= 20) {
            net_a += step_a;
            net_b += step_b;
            path += moved;
        }
        if (moved < 1e-10 * limit)
            return inside(a, arc_a) && inside(b, arc_b) ? std::optional(std::pair(arc_a, arc_b))
                                                        : std::nullopt;
    }
    // Kinks of curves and of their curvature keep the steps jumping about the closest point; where
    // curves bend more than they cross there is none, and steps lead on along them.
    const bool leads_on = std::abs(net_a) + std::abs(net_b) > 0.5 * path && path > 1e-4 * limit;
    return leads_on && metric.isIdentity() ? std::nullopt : best;
}

double TubePair::sharpness(double arc_a, double arc_b) const {
    const double s_a = arc_a / a.element_length, s_b = arc_b / b.element_length;
    const auto pa = curve_point(a, q, s_a), pb = curve_point(b, q, s_b);
    const Vec3 d = pb.position - pa.position;
    const double aa = pa.tangent.squaredNorm(), bb = pb.tangent.squaredNorm(),
                 cosine = pa.tangent.dot(pb.tangent) / std::sqrt(aa * bb),
                 along_a = 1 - d.dot(curve_bend(a, q, s_a)) / aa,
                 along_b = 1 + d.dot(curve_bend(b, q, s_b)) / bb;
    return 0.5 * (along_a + along_b) - std::hypot(0.5 * (along_a - along_b), cosine);
}

Station TubePair::station(double arc_a, double arc_b, double weight, std::int64_t index) const {
    return {a.inside(arc_a / a.element_length), b.inside(arc_b / b.element_length), weight, index};
}

double cell_length(const Tube& a, const Tube& b, double spacing) {
    if (!a.is_periodic() || !b.is_periodic())
        return spacing;
    const double element = 0.5 * (a.element_length + b.element_length);
    if (spacing <= element)
        return element / std::round(element / spacing);
    auto elements = std::lround(spacing / element);
    while (a.num_elements % elements != 0)
        --elements;
    return element * static_cast<double>(elements);
}

bool is_kept(const Tube& a, const Tube& b, const Station& s) {
    if (!a.is_periodic() || !b.is_periodic())
        return true;
    // Not at the first nodes: by symmetry contacts may be there, and a period on, but for
    // round-off.
    constexpr double cut = 0.31;
    const double element = 0.5 * (a.element_length + b.element_length);
    const double mean = 0.5 * (s.s_a * a.element_length + s.s_b * b.element_length) + cut * element;
    return mean >= 0 && mean < element * a.num_elements;
}

Vec3 TubePair::across(const Station& station) const {
    return position(b, q, station.s_b) - position(a, q, station.s_a);
}

namespace {

/// Sharpness below which no approach gets a point station: on curves that run along each other, or
/// wind around each other, small minima of the distance move far with every motion.
constexpr double flattest = 0.08;

/// Best known half difference of a cell.
struct Guess {
    double distance;
    double half_difference;
};

std::map<std::int64_t, Guess> covered_cells(const TubePair& tubes,
                                            const std::vector<ElementPair>& pairs, double spacing) {
    const double ha = tubes.a.element_length, hb = tubes.b.element_length, o = tubes.orientation;
    std::map<std::int64_t, Guess> cells;
    for (const auto& p : pairs) {
        const double first = ha * p.element_a + o * hb * p.element_b;
        const double low = 0.5 * (first + std::min(0.0, o * hb)),
                     high = 0.5 * (first + ha + std::max(0.0, o * hb));
        const double half_difference = 0.5 * (ha * p.s_a - o * hb * p.s_b);
        const auto last_cell = static_cast<std::int64_t>(std::ceil(high / spacing));
        for (auto k = static_cast<std::int64_t>(std::floor(low / spacing)); k < last_cell; ++k) {
            const auto [at, fresh] = cells.try_emplace(k, Guess{p.distance, half_difference});
            if (!fresh && p.distance < at->second.distance)
                at->second = {p.distance, half_difference};
        }
    }
    return cells;
}

/// Part of a cell where both tubes exist, for a given half difference.
std::pair<double, double> cut_at_ends(const TubePair& tubes, double low, double high,
                                      double half_difference) {
    const double o = tubes.orientation;
    const auto& [a, b] = std::tie(tubes.a, tubes.b);
    const double start_b = o > 0 ? b.low() : -b.high(), end_b = o > 0 ? b.high() : -b.low();
    return {std::max({low, a.low() - half_difference, half_difference + start_b}),
            std::min({high, a.high() - half_difference, half_difference + end_b})};
}

} // namespace

std::vector<Station> line_stations(const TubePair& tubes, const std::vector<ElementPair>& pairs,
                                   double spacing) {
    std::vector<Station> out;
    const double o = tubes.orientation;
    for (const auto& [k, guess] : covered_cells(tubes, pairs, spacing)) {
        const double low = spacing * k, high = low + spacing;
        auto difference = tubes.facing(0.5 * (low + high), guess.half_difference);
        if (!difference)
            continue;
        const auto [start, end] = cut_at_ends(tubes, low, high, *difference);
        if (end - start < 1e-6 * spacing)
            continue;
        const double middle = 0.5 * (start + end);
        if (end - start < (1 - 1e-9) * spacing)
            difference = tubes.facing(middle, *difference);
        if (difference)
            out.push_back(
                tubes.station(middle + *difference, o * (middle - *difference), end - start, k));
    }
    return out;
}

void add_point(std::vector<Station>& points, const TubePair& tubes, const Station& point,
               double spacing) {
    const bool taken = std::ranges::any_of(points, [&](const Station& p) {
        return std::abs(p.s_a - point.s_a) * tubes.a.element_length < 0.5 * spacing;
    });
    if (!taken)
        points.push_back(point);
}

double grown(double missed) {
    const double x = std::clamp((missed - 0.6) / 0.6, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

double point_weight(const TubePair& tubes, double arc_a, double arc_b, double spacing,
                    double tolerance) {
    // Half a spacing away along the mean curve the distance has grown by sharpness (spacing / 2)^2
    // / d.
    const double missed = tolerance * (tubes.a.radius + tubes.b.radius) * 4 / (spacing * spacing);
    const double s_a = arc_a / tubes.a.element_length, s_b = arc_b / tubes.b.element_length;
    const Vec3 way = position(tubes.b, tubes.q, s_b) - position(tubes.a, tubes.q, s_a);
    // From an end, it has grown by leaning spacing / 2.
    const double leaning = lean(tubes.a, tubes.q, s_a, way) + lean(tubes.b, tubes.q, s_b, -way),
                 sharp = tubes.sharpness(arc_a, arc_b) + 2 * leaning * way.norm() / spacing;
    return spacing * grown(sharp / std::max(flattest, missed));
}

std::optional<Station> point_station_near(const TubePair& tubes, double arc_a, double arc_b,
                                          double spacing, double tolerance) {
    const auto at = tubes.closest(arc_a, arc_b);
    if (!at || std::abs(at->first - arc_a) > 3 * spacing)
        return std::nullopt;
    const double weight = point_weight(tubes, at->first, at->second, spacing, tolerance);
    if (weight == 0)
        return std::nullopt;
    return tubes.station(at->first, at->second, weight, point_station);
}

std::vector<Station> point_stations(const TubePair& tubes, const std::vector<Station>& line,
                                    double spacing, double tolerance) {
    std::vector<Station> out;
    std::vector<double> distance;
    for (const auto& s : line)
        distance.push_back((tubes.metric * tubes.across(s)).norm());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto lower_than = [&](std::size_t j, std::int64_t step) {
            return j >= line.size() || line[j].index != line[i].index + step ||
                   distance[i] < distance[j] || (step < 0 && distance[i] == distance[j]);
        };
        if (!lower_than(i - 1, -1) || !lower_than(i + 1, 1))
            continue;
        const auto point =
            point_station_near(tubes, line[i].s_a * tubes.a.element_length,
                               line[i].s_b * tubes.b.element_length, spacing, tolerance);
        if (point)
            add_point(out, tubes, *point, spacing);
    }
    return out;
}

std::vector<Station> share_length(std::vector<Station> line, const std::vector<Station>& points,
                                  const TubePair& tubes) {
    const auto mean = [&](const Station& s) {
        return 0.5 * (s.s_a * tubes.a.element_length +
                      tubes.orientation * s.s_b * tubes.b.element_length);
    };
    for (auto& s : line) {
        const double low = mean(s) - 0.5 * s.weight, high = mean(s) + 0.5 * s.weight;
        for (const auto& p : points)
            s.weight -= std::max(0.0, std::min(high, mean(p) + 0.5 * p.weight) -
                                          std::max(low, mean(p) - 0.5 * p.weight));
    }
    std::erase_if(line, [](const Station& s) { return s.weight <= 0; });
    line.insert(line.end(), points.begin(), points.end());
    return line;
}

} // namespace braidx
