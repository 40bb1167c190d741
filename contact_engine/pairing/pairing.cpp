#include "pairing.h"

#include "history.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace braidx {
namespace {

using Tubes = std::vector<Tube>;

bool mine(std::int32_t a, std::int32_t b, const PairingOptions& options) {
    return (std::int64_t{a} * 7919 + b) % options.num_parts == options.part;
}

/// Surface particle of a tube that faces `direction`, in section coordinates (beams only).
void face(const Tube& tube, Unknowns q, double s, const Vec3& direction, double (&xi)[2]) {
    if (!tube.has_directors())
        return;
    const auto support = element_support(tube, s);
    const double c1 = director(tube, q, support, 1).dot(direction), c2 = director(tube, q, support, 2).dot(direction);
    const double norm = std::max(std::hypot(c1, c2), 1e-12);
    xi[0] = tube.radius * c1 / norm;
    xi[1] = tube.radius * c2 / norm;
}

/// Makes the contact elements of one zone or crossing and gives them one penalty.
class Builder {
  public:
    Builder(const Tubes& tubes, Unknowns q, const ContactElements& previous, const PairingOptions& options)
        : tubes_(tubes), q_(q), options_(options), history_(previous, tubes) {}

    void add(std::int32_t a, std::int32_t b, const std::vector<Station>& stations, const Crossing* crossing,
             std::int32_t crossing_number) {
        const std::size_t first = elements.size();
        for (const auto& s : stations) {
            ContactElement e{.tube_a = a, .tube_b = b, .s_a = s.s_a, .s_b = s.s_b, .station = s.index,
                             .normal = crossing ? crossing->normal : centre_to_centre(a, b, s), .weight = s.weight,
                             .stiffness = 0};
            e.crossing = crossing_number;
            e.zone = num_zones_;
            if (const auto* old = history_.predecessor(e, 4 * options_.spacing))
                inherit(e, *old);
            face(tubes_[a], q_, s.s_a, e.normal, e.xi_a);
            face(tubes_[b], q_, s.s_b, -e.normal, e.xi_b);
            elements.push_back(e);
        }
        if (elements.size() > first)
            share_stiffness(first);
    }

    ContactElements elements;

  private:
    Vec3 centre_to_centre(std::int32_t a, std::int32_t b, const Station& s) const {
        const Vec3 d = position(tubes_[b], q_, s.s_b) - position(tubes_[a], q_, s.s_a);
        const double length = d.norm();
        if (length > 1e-9 * tubes_[a].radius)
            return d / length;
        const Vec3 t = curve_point(tubes_[a], q_, s.s_a).tangent; // coinciding centres: any normal will do
        return t.unitOrthogonal();
    }

    void share_stiffness(std::size_t first) {
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

/// Crossings not separated yet, by pair of tubes: there the stacking order rules, elsewhere geometry.
using Unseparated = std::multimap<std::pair<std::int32_t, std::int32_t>, const Crossing*>;

Unseparated add_crossings(Builder& builder, const Tubes& tubes, const std::vector<Crossing>& crossings, Unknowns q,
                          const PairingOptions& options) {
    Unseparated out;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const auto& c = crossings[i];
        if (!mine(c.tube_a, c.tube_b, options))
            continue;
        const auto stations = crossing_stations(tubes, q, c, options.spacing, options.crossing);
        if (stations.empty())
            continue;
        builder.add(c.tube_a, c.tube_b, stations, &c, static_cast<std::int32_t>(i));
        out.emplace(std::pair(c.tube_a, c.tube_b), &c);
    }
    return out;
}

void add_zone(Builder& builder, const Tubes& tubes, const ProximityZone& zone, const Unseparated& unseparated,
              Unknowns q, const PairingOptions& options) {
    const TubePair pair{tubes[zone.tube_a], tubes[zone.tube_b], q, zone.orientation};
    auto stations = line_stations(pair, zone.pairs, options.spacing);
    const auto points = point_stations(pair, stations, options.spacing, options.point_tolerance);
    stations.insert(stations.end(), points.begin(), points.end());
    const double reach = pair.a.radius + pair.b.radius + options.search.margin;
    const auto [first, last] = unseparated.equal_range({zone.tube_a, zone.tube_b});
    std::erase_if(stations, [&](const Station& s) {
        const double arc_a = s.s_a * pair.a.element_length, arc_b = s.s_b * pair.b.element_length;
        return pair.across(s).norm() > reach ||
               std::any_of(first, last, [&](const auto& c) { return c.second->contains(arc_a, arc_b); });
    });
    builder.add(zone.tube_a, zone.tube_b, stations, nullptr, -1);
}

} // namespace

ContactElements make_contact_elements(const Tubes& tubes, const std::vector<Crossing>& crossings, Unknowns q,
                                      const ContactElements& previous, const PairingOptions& options) {
    Builder builder(tubes, q, previous, options);
    const auto unseparated = add_crossings(builder, tubes, crossings, q, options);
    for (const auto& zone : proximity_zones(tubes, q, close_pairs(tubes, q, options.search)))
        if (mine(zone.tube_a, zone.tube_b, options))
            add_zone(builder, tubes, zone, unseparated, q, options);
    return std::move(builder.elements);
}

} // namespace braidx
