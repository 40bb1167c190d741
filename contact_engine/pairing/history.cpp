#include "history.h"

#include <Eigen/Geometry>
#include <cmath>

namespace braidx {
History::History(const ContactElements& previous, const std::vector<Tube>& tubes)
    : previous_(previous), tubes_(tubes) {
    places_.reserve(previous.size());
    for (std::size_t i = 0; i < previous.size(); ++i)
        places_.emplace_back(Place{previous[i].tube_a, previous[i].tube_b, previous[i].station}, i);
    std::ranges::sort(places_);
}

bool History::knows(std::int32_t tube_a, std::int32_t tube_b) const {
    const auto at =
        std::ranges::lower_bound(places_, Place{tube_a, tube_b, INT64_MIN}, {}, &Entry::first);
    return at != places_.end() && std::get<0>(at->first) == tube_a &&
           std::get<1>(at->first) == tube_b;
}

const ContactElement* History::predecessor(const ContactElement& element, double reach) const {
    const ContactElement* best = nullptr;
    for_each(element.tube_a, element.tube_b, element.station, [&](const ContactElement& old) {
        const Tube& a = tubes_[element.tube_a];
        double apart = old.s_a - element.s_a;
        const double periods = a.is_periodic() ? std::round(apart / a.num_elements) : 0;
        apart = std::abs(apart - periods * a.num_elements) * a.element_length;
        if (!against_rigid(element)) {
            const Tube& b = tubes_[element.tube_b];
            apart += std::abs(old.s_b - periods * b.num_elements - element.s_b) * b.element_length;
        }
        if (apart < reach) {
            reach = apart;
            best = &old;
        }
    });
    return best;
}

void inherit(ContactElement& element, const ContactElement& predecessor, bool keep_side) {
    if (keep_side && element.crossing < 0 && !against_rigid(element) &&
        element.normal.dot(predecessor.normal) < 0)
        element.normal = -element.normal;
    const double length = predecessor.slip.norm();
    if (length > 0) {
        const auto turn = Eigen::Quaterniond::FromTwoVectors(predecessor.normal, element.normal);
        element.slip = turn * predecessor.slip;
        element.slip -= element.normal.dot(element.slip) * element.normal;
    }
    element.work = predecessor.work;
    element.stiffness = predecessor.stiffness;
}

} // namespace braidx
