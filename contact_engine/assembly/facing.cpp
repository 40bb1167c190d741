#include "facing.h"

#include "../pairing/stations.h"

#include <cmath>

namespace braidx {
namespace {

constexpr double furthest =
    1.5; // elements that sections may move before the contact elements are made anew

std::optional<Station> follow(const TubePair& pair, const ContactElement& e) {
    const double arc_a = e.s_a * pair.a.element_length, arc_b = e.s_b * pair.b.element_length,
                 o = pair.orientation;
    Station out{};
    if (e.station == point_station) {
        const auto at = pair.closest(arc_a, arc_b);
        if (!at)
            return std::nullopt;
        out = pair.station(at->first, at->second, e.weight, e.station);
    } else {
        const double mean = 0.5 * (arc_a + o * arc_b);
        const auto half_difference = pair.facing(mean, 0.5 * (arc_a - o * arc_b));
        if (!half_difference)
            return std::nullopt;
        out = pair.station(mean + *half_difference, o * (mean - *half_difference), e.weight,
                           e.station);
    }
    const bool near = std::abs(out.s_a - e.s_a) < furthest && std::abs(out.s_b - e.s_b) < furthest;
    return near ? std::optional(out) : std::nullopt;
}

} // namespace

Facing facing(const DeformableSurfaces& surfaces, const ContactElement& e, Unknowns q) {
    Facing out{e.s_a, e.s_b, e.normal, 1, 0};
    if (e.follows == 0)
        return out;
    const TubePair pair{surfaces.tube(e.surface_a), surfaces.tube(e.surface_b), q, e.follows};
    const auto station = follow(pair, e);
    if (!station)
        return out;
    const Vec3 across = pair.across(*station);
    const double distance = across.norm();
    if (distance < 1e-6 * pair.a.radius)
        return out;
    out = {station->s_a, station->s_b, across / distance, 1, distance};
    if (out.normal.dot(e.normal) < 0) {
        out.normal = -out.normal;
        out.side = -1;
    }
    return out;
}

void freeze_sections(ContactElements& elements) {
    for (auto& e : elements)
        e.follows = 0;
}

} // namespace braidx
