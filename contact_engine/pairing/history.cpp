#include "history.h"

#include <cmath>

namespace braidx {
History::History(const ContactElements& previous, const DeformableSurfaces& surfaces)
    : previous_(previous), surfaces_(surfaces) {
    places_.reserve(previous.size());
    for (std::size_t i = 0; i < previous.size(); ++i)
        places_.emplace_back(
            Place{previous[i].surface_a, previous[i].surface_b, previous[i].station}, i);
    std::ranges::sort(places_);
}

bool History::knows(std::int32_t surface_a, std::int32_t surface_b) const {
    const auto at = std::ranges::lower_bound(places_, Place{surface_a, surface_b, INT64_MIN}, {},
                                             &Entry::first);
    return at != places_.end() && std::get<0>(at->first) == surface_a &&
           std::get<1>(at->first) == surface_b;
}

/// How far apart two elements of a tube with the same other surface are, mm of arc length.
double History::along_tubes(const ContactElement& old, const ContactElement& element) const {
    const Tube& a = surfaces_.tube(element.surface_a);
    double apart = old.s_a - element.s_a;
    const double periods = a.is_periodic() ? std::round(apart / a.num_elements) : 0;
    apart = a.apart(apart, periods * a.num_elements) * a.element_length;
    if (against_rigid(element) || element.facet_b >= 0)
        return apart;
    const Tube& b = surfaces_.tube(element.surface_b);
    return apart + b.apart(old.s_b - periods * b.num_elements, element.s_b) * b.element_length;
}

const ContactElement* History::predecessor(const ContactElement& element, double reach) const {
    const ContactElement* best = nullptr;
    for_each(element.surface_a, element.surface_b, element.station, [&](const ContactElement& old) {
        const double apart = element.facet_a >= 0 ? 0.0 : along_tubes(old, element);
        if (apart < reach) {
            reach = apart;
            best = &old;
        }
    });
    return best;
}

void inherit(ContactElement& element, const ContactElement& predecessor, bool keep_side) {
    const Vec3 turned = element.turn * (predecessor.turn.transpose() * predecessor.normal);
    if (keep_side && element.crossing < 0 && !against_rigid(element) && element.facet_a < 0 &&
        element.facet_b < 0 && element.normal.dot(turned) < 0)
        element.normal = -element.normal;
    element.slip = predecessor.slip;
    element.work = predecessor.work;
    element.stiffness = predecessor.stiffness;
    element.multiplier = predecessor.multiplier;
}

} // namespace braidx
