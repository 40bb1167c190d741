#include "pairing.h"

#include "history.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace braidx {
namespace {

using Tubes = std::vector<Tube>;

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

/// Makes the contact elements of one zone or crossing and gives them one penalty.
class Builder {
public:
    Builder(const Tubes& tubes, Unknowns q, const ContactElements& previous,
            const PairingOptions& options)
        : tubes_(tubes), q_(q), options_(options), history_(previous, tubes) {}

    void add_zone(std::int32_t a, std::int32_t b, int orientation,
                  const std::vector<Station>& stations) {
        const auto movable = [&](std::int32_t t, double s) {
            return s > 0 && s < tubes_[t].num_elements &&
                   (tubes_[t].smooth || tubes_[t].degree == 2);
        };
        const std::size_t first = elements.size();
        for (const auto& s : stations) {
            const int follows = movable(a, s.s_a) && movable(b, s.s_b) ? orientation : 0;
            add({.tube_a = a,
                 .tube_b = b,
                 .s_a = s.s_a,
                 .s_b = s.s_b,
                 .station = s.index,
                 .normal = centre_to_centre(a, b, s),
                 .follows = follows,
                 .weight = s.weight,
                 .stiffness = 0});
        }
        share_stiffness(first);
    }

    /// The tube `a` may touch a rigid surface anywhere: one proximity zone per tube.
    void add_wall(std::int32_t a, const Rigid& rigid, std::int32_t number) {
        const Tube& tube = tubes_[a];
        const std::size_t first = elements.size();
        const auto count = static_cast<std::int64_t>(std::ceil(tube.length() / options_.spacing));
        const double spacing = tube.length() / static_cast<double>(count);
        for (std::int64_t k = 0; k < count; ++k) {
            const double s = (static_cast<double>(k) + 0.5) * spacing / tube.element_length;
            const Vec3 x = position(tube, q_, s);
            const auto wall = rigid.nearest(x);
            if ((x - wall.position).dot(wall.normal) > tube.radius + options_.search.margin)
                continue;
            add({.tube_a = a,
                 .tube_b = -1 - number,
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
        share_stiffness(first);
    }

    void add_crossing(const Crossing& crossing, std::int32_t number,
                      const std::vector<OrientedStation>& stations) {
        const std::size_t first = elements.size();
        for (const auto& [s, normal, allowance] : stations)
            add({.tube_a = crossing.tube_a,
                 .tube_b = crossing.tube_b,
                 .s_a = s.s_a,
                 .s_b = s.s_b,
                 .station = s.index,
                 .normal = normal,
                 .weight = s.weight,
                 .stiffness = 0,
                 .allowance = allowance,
                 .crossing = number});
        share_stiffness(first);
    }

    ContactElements elements;
    const History& history() const { return history_; }

private:
    void add(ContactElement e) {
        e.zone = num_zones_;
        if (const auto* old = history_.predecessor(e, 4 * options_.spacing))
            inherit(e, *old, options_.keep_side);
        face(tubes_[e.tube_a], q_, e.s_a, e.normal, e.xi_a);
        if (!against_rigid(e)) {
            face(tubes_[e.tube_b], q_, e.s_b, -e.normal, e.xi_b);
            e.body_b = tubes_[e.tube_b].body;
        }
        elements.push_back(e);
    }

    Vec3 centre_to_centre(std::int32_t a, std::int32_t b, const Station& s) const {
        const Vec3 d = position(tubes_[b], q_, s.s_b) - position(tubes_[a], q_, s.s_a);
        const double length = d.norm();
        if (length > 1e-9 * tubes_[a].radius)
            return d / length;
        const Vec3 t =
            curve_point(tubes_[a], q_, s.s_a).tangent; // coinciding centres: any normal will do
        return t.unitOrthogonal();
    }

    void share_stiffness(std::size_t first) {
        if (first == elements.size())
            return;
        double stiffness = 0;
        for (std::size_t i = first; i < elements.size(); ++i)
            stiffness = std::max(stiffness, elements[i].stiffness);
        for (std::size_t i = first; i < elements.size(); ++i)
            elements[i].stiffness = stiffness > 0 ? stiffness : options_.stiffness;
        ++num_zones_;
    }

    const Tubes& tubes_;
    Unknowns q_;
    const PairingOptions& options_;
    History history_;
    std::int32_t num_zones_ = 0;
};

/// Crossings not separated yet, by pair of tubes: there the stacking order rules, elsewhere
/// geometry.
using Unseparated = std::multimap<std::pair<std::int32_t, std::int32_t>, const Crossing*>;

Unseparated add_crossings(Builder& builder, const Tubes& tubes,
                          const std::vector<Crossing>& crossings, Unknowns q,
                          const PairingOptions& options) {
    Unseparated out;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const auto& c = crossings[i];
        if (!is_own(options, c.tube_a, c.tube_b))
            continue;
        const auto stations = crossing_stations(tubes, q, c, options.spacing, options.crossing);
        if (stations.empty())
            continue;
        builder.add_crossing(c, static_cast<std::int32_t>(i), stations);
        out.emplace(std::pair(c.tube_a, c.tube_b), &c);
    }
    return out;
}

bool covers(const ProximityZone& zone, const Station& s) {
    return std::ranges::any_of(zone.pairs, [&](const ElementPair& p) {
        return std::abs(p.element_a + 0.5 - s.s_a) < 1.5 &&
               std::abs(p.element_b + 0.5 - s.s_b) < 1.5;
    });
}

/// Point stations of before, at the closest approaches they have now. Their weights stay while the
/// equilibrium of an increment is being found: a weight and the shape of the yarns that it depends
/// on would chase each other. One whose approach is gone ends: line stations take its length over,
/// and it does not come back while points are kept.
std::vector<Station> kept_points(const TubePair& pair, const ProximityZone& zone,
                                 const History& history, double spacing) {
    std::vector<Station> out;
    history.for_each(zone.tube_a, zone.tube_b, [&](const ContactElement& old) {
        if (old.station != point_station)
            return;
        const double arc_a = old.s_a * pair.a.element_length,
                     arc_b = old.s_b * pair.b.element_length;
        const auto at = pair.closest(arc_a, arc_b);
        if (!at || std::abs(at->first - arc_a) > spacing)
            return;
        const auto kept = pair.station(at->first, at->second, old.weight, point_station);
        if (covers(zone, kept))
            add_point(out, pair, kept, spacing);
    });
    return out;
}

/// Closest approaches along line stations and near point stations of before.
std::vector<Station> new_points(const TubePair& pair, const ProximityZone& zone,
                                const std::vector<Station>& line, const History& history,
                                const PairingOptions& options) {
    auto out = point_stations(pair, line, options.spacing, options.point_tolerance);
    for (const auto& old : kept_points(pair, zone, history, options.spacing)) {
        const auto at = point_station_near(pair, old.s_a * pair.a.element_length,
                                           old.s_b * pair.b.element_length, options.spacing,
                                           options.point_tolerance);
        if (at && covers(zone, *at))
            add_point(out, pair, *at, options.spacing);
    }
    return out;
}

void add_zone(Builder& builder, const Tubes& tubes, const ProximityZone& zone,
              const Unseparated& unseparated, Unknowns q, const PairingOptions& options) {
    const TubePair pair{tubes[zone.tube_a], tubes[zone.tube_b], q, zone.orientation};
    auto line = line_stations(pair, zone.pairs, options.spacing);
    const auto points = options.keep_points
                            ? kept_points(pair, zone, builder.history(), options.spacing)
                            : new_points(pair, zone, line, builder.history(), options);
    auto stations = share_length(std::move(line), points, pair);
    const double reach = pair.a.radius + pair.b.radius + options.search.margin;
    const auto [first, last] = unseparated.equal_range({zone.tube_a, zone.tube_b});
    std::erase_if(stations, [&](const Station& s) {
        const double arc_a = s.s_a * pair.a.element_length, arc_b = s.s_b * pair.b.element_length;
        return pair.across(s).norm() > reach || std::any_of(first, last, [&](const auto& c) {
                   return c.second->contains(arc_a, arc_b);
               });
    });
    builder.add_zone(zone.tube_a, zone.tube_b, zone.orientation, stations);
}

} // namespace

bool is_own(const PairingOptions& options, std::int64_t tube, std::int64_t other) {
    return (tube * 7919 + other) % options.num_parts == options.part;
}

ContactElements make_contact_elements(const Surfaces& surfaces, Unknowns q,
                                      const ContactElements& previous,
                                      const PairingOptions& options) {
    const auto& tubes = surfaces.tubes;
    Builder builder(tubes, q, previous, options);
    const auto unseparated = add_crossings(builder, tubes, surfaces.crossings, q, options);
    for (const auto& zone : proximity_zones(tubes, q, close_pairs(tubes, q, options.search)))
        if (is_own(options, zone.tube_a, zone.tube_b))
            add_zone(builder, tubes, zone, unseparated, q, options);
    for (std::size_t r = 0; r < surfaces.rigid.size(); ++r)
        for (std::int32_t a = 0; a < static_cast<std::int32_t>(tubes.size()); ++a)
            if (is_own(options, a, static_cast<std::int64_t>(r)))
                builder.add_wall(a, surfaces.rigid[r], static_cast<std::int32_t>(r));
    return std::move(builder.elements);
}

} // namespace braidx
