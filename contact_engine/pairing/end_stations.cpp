#include "end_stations.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

/// Rest arc length of the end of a tube that is nearer to another, mm.
double nearer_end(const Tube& tube, double arc) {
    return 2 * arc < tube.low() + tube.high() ? tube.low() : tube.high();
}

/// The place of a tube that is nearest to a point, found from a rest arc length on, mm.
double nearest_to(const Tube& tube, Unknowns q, const Vec3& x, double arc) {
    for (int iteration = 0; iteration < 30; ++iteration) {
        const double s = arc / tube.element_length;
        const auto at = curve_point(tube, q, s);
        const Vec3 d = x - at.position;
        const double convex = at.tangent.squaredNorm(),
                     exact = convex - d.dot(curve_bend(tube, q, s));
        // Newton's method where the distance is convex, steps of an element at most
        const double step = std::clamp(d.dot(at.tangent) / (exact > 0.2 * convex ? exact : convex),
                                       -tube.element_length, tube.element_length);
        const double next = tube.inside((arc + step) / tube.element_length) * tube.element_length;
        const double moved = std::abs(next - arc);
        arc = next;
        if (moved < 1e-10 * tube.element_length)
            break;
    }
    return arc;
}

/// Whether a place may be the nearest one of its tube in a direction: between the ends, or at an
/// end that touches and that the direction leans out of.
bool may_be_nearest(const Tube& tube, Unknowns q, double arc, const Vec3& way) {
    const double s = arc / tube.element_length;
    if (end_at(tube, s) != 0)
        return lean(tube, q, s, way) >= 0;
    return tube.is_closed || (arc > tube.low() && arc < tube.high());
}

/// Elements that sections may move from where they are looked for.
constexpr double furthest = 1.5;

bool is_near(const Tube& tube, double arc, double other) {
    return std::abs(arc - other) <= furthest * tube.element_length;
}

/// The place of `other` nearest to the nearer end of `own`, if the way leans out of that end.
struct FromEnd {
    double own, other, distance; ///< rest arc lengths, mm
};
std::optional<FromEnd> from_end(const Tube& own, const Tube& other, Unknowns q, double arc_own,
                                double arc_other) {
    if (!own.has_ends())
        return std::nullopt;
    const double end = nearer_end(own, arc_own);
    if (!is_near(own, end, arc_own))
        return std::nullopt;
    const Vec3 x = position(own, q, end / own.element_length);
    const double arc = nearest_to(other, q, x, arc_other);
    const Vec3 way = position(other, q, arc / other.element_length) - x;
    const bool coincide = way.norm() < 1e-9 * own.radius; // no way leads from one to the other
    if (coincide || !is_near(other, arc, arc_other) || !may_be_nearest(own, q, end, way) ||
        !may_be_nearest(other, q, arc, -way))
        return std::nullopt;
    return FromEnd{end, arc, way.norm()};
}

} // namespace

double weight_at(const Tube& tube, Unknowns q, double s, const Vec3& direction, double spacing,
                 double tolerance) {
    if (end_at(tube, s) == 0)
        return spacing;
    return spacing * grown(0.5 * lean(tube, q, s, direction) * spacing / tolerance);
}

std::optional<std::pair<double, double>> closest_at_ends(const TubePair& tubes, double arc_a,
                                                         double arc_b) {
    const auto& [a, b] = std::tie(tubes.a, tubes.b);
    if (&a == &b)
        return std::nullopt;
    const auto of_a = from_end(a, b, tubes.q, arc_a, arc_b),
               of_b = from_end(b, a, tubes.q, arc_b, arc_a);
    if (of_a && (!of_b || of_a->distance <= of_b->distance))
        return std::pair(of_a->own, of_a->other);
    if (of_b)
        return std::pair(of_b->other, of_b->own);
    return std::nullopt;
}

std::optional<std::pair<double, double>> closest_anywhere(const TubePair& tubes, double arc_a,
                                                          double arc_b) {
    const auto inside = tubes.closest(arc_a, arc_b);
    return inside ? inside : closest_at_ends(tubes, arc_a, arc_b);
}

void add_end_stations(std::vector<Station>& points, const TubePair& tubes,
                      const std::vector<ElementPair>& pairs, double spacing, double tolerance) {
    const auto is_last = [](const Tube& tube, std::int32_t element) {
        return tube.has_ends() &&
               (element == tube.first_element() || element == tube.end_element() - 1);
    };
    for (const auto& p : pairs) {
        if (!is_last(tubes.a, p.element_a) && !is_last(tubes.b, p.element_b))
            continue;
        const auto at =
            closest_at_ends(tubes, p.s_a * tubes.a.element_length, p.s_b * tubes.b.element_length);
        if (!at)
            continue;
        const double weight = point_weight(tubes, at->first, at->second, spacing, tolerance);
        if (weight > 0)
            add_point(points, tubes, tubes.station(at->first, at->second, weight, point_station),
                      spacing);
    }
}

} // namespace braidx
