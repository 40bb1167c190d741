#include "near_stretches.h"

#include <algorithm>
#include <limits>

namespace braidx {

NearStretches::NearStretches(const Tube& tube, Unknowns q, const Box& box, double reach)
    : tube_(tube), q_(q), reach_(reach) {
    for (auto e = tube.first_element(); e < tube.end_element(); ++e) {
        const Vec3 from = position(tube, q, e), way = position(tube, q, e + 1) - from;
        if (box.distance_to(from + 0.5 * way) < reach + way.norm())
            chords_.push_back({e, from, way});
    }
}

std::optional<double> NearStretches::nearest_section(const Vec3& x) const {
    double least = std::numeric_limits<double>::infinity(), s = 0;
    for (const auto& [element, from, way] : chords_) {
        const double t = std::clamp(way.dot(x - from) / way.squaredNorm(), 0.0, 1.0);
        const double distance = (x - from - t * way).norm();
        if (distance < least) {
            least = distance;
            s = element + t;
        }
    }
    return least < 2 * reach_ ? braidx::nearest_section(tube_, q_, x, s) : std::nullopt;
}

} // namespace braidx
