#include "pairing.h"

#include "../parallel.h"
#include "../surfaces/finite.h"
#include "builder.h"
#include "end_stations.h"
#include "rules.h"
#include "skin_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace braidx {
namespace {

using Tubes = std::vector<Tube>;

/// Contact elements found on several threads, in the order in which one would have found them.
using Parts = std::vector<ContactElements>;

/// Stations of each crossing that is not separated yet.
using CrossingStations = std::vector<std::vector<OrientedStation>>;

/// Crossings not separated yet, by pair of tubes: there the stacking order rules, elsewhere
/// geometry.
using Unseparated = std::multimap<std::pair<std::int32_t, std::int32_t>, const Crossing*>;

CrossingStations own_crossings(const Surfaces& surfaces, Unknowns q,
                               const PairingOptions& options) {
    const auto& crossings = surfaces.crossings;
    return parallel_map(crossings.size(), options.num_threads, [&](std::size_t i) {
        const auto& c = crossings[i];
        if (!is_own(options, c.tube_a, c.tube_b) ||
            !may_touch(options, surfaces.tubes, c.tube_a, c.tube_b))
            return std::vector<OrientedStation>{};
        return crossing_stations(surfaces.tubes, q, c, options.spacing, options.crossing);
    });
}

Parts crossing_parts(const Builder& builder, const std::vector<Crossing>& crossings,
                     const CrossingStations& stations, int num_threads) {
    return parallel_map(crossings.size(), num_threads, [&](std::size_t i) {
        return builder.crossing(crossings[i], static_cast<std::int32_t>(i), stations[i]);
    });
}

Unseparated unseparated_crossings(const std::vector<Crossing>& crossings,
                                  const CrossingStations& stations) {
    Unseparated out;
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (!stations[i].empty())
            out.emplace(std::pair(crossings[i].tube_a, crossings[i].tube_b), &crossings[i]);
    return out;
}

bool covers(const ProximityZone& zone, const Station& s) {
    return std::ranges::any_of(zone.pairs, [&](const ElementPair& p) {
        return std::abs(p.element_a + 0.5 - s.s_a) < 1.5 &&
               std::abs(p.element_b + 0.5 - s.s_b) < 1.5;
    });
}

/// Adds a point station of a zone; one that has come over the joint of a closed tube is left to the
/// zone there.
void add_own(std::vector<Station>& points, const TubePair& pair, const ProximityZone& zone,
             Station point, double spacing) {
    point.s_a = pair.a.once_around(point.s_a);
    point.s_b = pair.b.once_around(point.s_b);
    if (covers(zone, point))
        add_point(points, pair, point, spacing);
}

/// Numbers of periods away from an element where it occurs again.
std::vector<int> periods_of(const TubePair& pair) {
    return pair.a.is_periodic() && pair.b.is_periodic() ? std::vector{0, -1, 1} : std::vector{0};
}

/// Spacings that a closest approach may move in one update and still be the one of before: curves
/// that are found to cross elsewhere cross in a point there, too.
constexpr double farthest_jump = 4;

/// Point stations of before, at the closest approaches they have now. Their weights stay while the
/// equilibrium of an increment is being found: a weight and the shape of the yarns that it depends
/// on would chase each other. One whose approach is gone ends: line stations take its length over,
/// and it does not come back while points are kept.
std::vector<Station> kept_points(const TubePair& pair, const ProximityZone& zone,
                                 const History& history, double spacing) {
    std::vector<Station> out;
    history.for_each(zone.tube_a, zone.tube_b, point_station, [&](const ContactElement& old) {
        for (const int periods : periods_of(pair)) {
            const double arc_a = old.s_a * pair.a.element_length + periods * pair.a.length(),
                         arc_b = old.s_b * pair.b.element_length + periods * pair.b.length();
            const auto at = closest_anywhere(pair, arc_a, arc_b);
            if (!at || std::abs(at->first - arc_a) > farthest_jump * spacing)
                continue;
            add_own(out, pair, zone, pair.station(at->first, at->second, old.weight, point_station),
                    spacing);
        }
    });
    return out;
}

/// Weights of point stations from one increment to the next: a new one, on tubes that touched
/// before, starts with this share of the spacing, and grows and fades by no more than the factor. A
/// point that took over at once what line stations carried would push yarns away that had come to
/// rest.
constexpr double first_share = 0.02, change = 2;

void ease(std::vector<Station>& points, const std::vector<Station>& before, const TubePair& pair,
          double spacing) {
    for (auto& p : points) {
        double weight = 0;
        for (const auto& old : before)
            if (std::abs(old.s_a - p.s_a) * pair.a.element_length < 0.5 * spacing)
                weight = std::max(weight, old.weight);
        p.weight = std::clamp(p.weight, weight / change, change * weight + first_share * spacing);
    }
}

/// Closest approaches along line stations and near point stations of before.
std::vector<Station> new_points(const TubePair& pair, const ProximityZone& zone,
                                const std::vector<Station>& line, const History& history,
                                double spacing, double tolerance) {
    std::vector<Station> out = point_stations(pair, line, spacing, tolerance);
    add_end_stations(out, pair, zone.pairs, spacing, tolerance);
    if (pair.a.is_closed || pair.b.is_closed)
        for (const auto& found : std::exchange(out, {}))
            add_own(out, pair, zone, found, spacing);
    const auto before = kept_points(pair, zone, history, spacing);
    for (auto old : before) {
        old.weight = point_weight(pair, old.s_a * pair.a.element_length,
                                  old.s_b * pair.b.element_length, spacing, tolerance);
        add_point(out, pair, old, spacing);
    }
    if (history.knows(zone.tube_a, zone.tube_b))
        ease(out, before, pair, spacing);
    std::erase_if(out, [&](const Station& p) { return p.weight < first_share / change * spacing; });
    return out;
}

/// Stations of a zone, but for those of crossings that are not separated yet.
std::vector<Station> zone_stations(const Tubes& tubes, Unknowns q, const ProximityZone& zone,
                                   const History& history, const Unseparated& unseparated,
                                   const PairingOptions& options) {
    const TubePair pair{tubes[zone.tube_a], tubes[zone.tube_b], q, zone.orientation};
    const double spacing = cell_length(pair.a, pair.b, options.spacing);
    auto line = line_stations(pair, zone.pairs, spacing);
    const auto points = options.within_increment ? kept_points(pair, zone, history, spacing)
                                                 : new_points(pair, zone, line, history, spacing,
                                                              options.point_tolerance);
    auto stations = share_length(std::move(line), points, pair);
    const double reach = pair.a.radius + pair.b.radius + options.search.margin;
    const auto [first, last] = unseparated.equal_range({zone.tube_a, zone.tube_b});
    std::erase_if(stations, [&](const Station& s) {
        const double arc_a = s.s_a * pair.a.element_length, arc_b = s.s_b * pair.b.element_length;
        return !is_kept(pair.a, pair.b, s) || pair.across(s).norm() > reach ||
               std::any_of(first, last,
                           [&](const auto& c) { return c.second->contains(arc_a, arc_b); });
    });
    return stations;
}

Parts zone_parts(const Builder& builder, const Tubes& tubes, Unknowns q,
                 const Unseparated& unseparated, const PairingOptions& options) {
    const auto zones =
        proximity_zones(tubes, q, close_pairs(tubes, q, options.search, options.num_threads));
    return parallel_map(zones.size(), options.num_threads, [&](std::size_t i) {
        const auto& zone = zones[i];
        if (!is_own(options, zone.tube_a, zone.tube_b) ||
            !may_touch(options, tubes, zone.tube_a, zone.tube_b))
            return ContactElements{};
        return builder.zone(zone,
                            zone_stations(tubes, q, zone, builder.history(), unseparated, options));
    });
}

Parts wall_parts(const Builder& builder, const Surfaces& surfaces, const PairingOptions& options) {
    const auto num_tubes = surfaces.tubes.size();
    const auto num_pairs = surfaces.rigid.size() * num_tubes;
    return parallel_map(num_pairs, options.num_threads, [&](std::size_t i) {
        const auto rigid = static_cast<std::int32_t>(i / num_tubes),
                   tube = static_cast<std::int32_t>(i % num_tubes);
        if (!is_own(options, tube, rigid) ||
            !may_touch(options, surfaces.tubes[tube].body, surfaces.rigid[rigid].body))
            return ContactElements{};
        return builder.wall(tube, surfaces.rigid[rigid], rigid);
    });
}

/// Joins parts, and numbers them as zones.
ContactElements joined(std::initializer_list<const Parts*> all) {
    ContactElements out;
    std::int32_t num_zones = 0;
    for (const auto* parts : all)
        for (const auto& part : *parts) {
            if (part.empty())
                continue;
            out.insert(out.end(), part.begin(), part.end());
            std::for_each(out.end() - std::ssize(part), out.end(),
                          [&](ContactElement& e) { e.zone = num_zones; });
            ++num_zones;
        }
    return out;
}

} // namespace

bool is_own(const PairingOptions& options, std::int64_t surface, std::int64_t other) {
    return (surface * 7919 + other) % options.num_parts == options.part;
}

ContactElements make_contact_elements(const Surfaces& surfaces, Unknowns q,
                                      const ContactElements& previous,
                                      const PairingOptions& options, Unknowns q_start) {
    require_finite(q);
    require_finite(q_start);
    const Builder builder(surfaces.deformable(), q, q_start.empty() ? q : q_start, previous,
                          options);
    const auto stations = own_crossings(surfaces, q, options);
    const auto crossings =
        crossing_parts(builder, surfaces.crossings, stations, options.num_threads);
    const auto unseparated = unseparated_crossings(surfaces.crossings, stations);
    const auto zones = zone_parts(builder, surfaces.tubes, q, unseparated, options);
    const auto walls = wall_parts(builder, surfaces, options);
    const auto skins = skin_parts(surfaces, q, builder, options);
    return joined({&crossings, &zones, &walls, &skins});
}

} // namespace braidx
