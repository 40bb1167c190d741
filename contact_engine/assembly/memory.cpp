#include "memory.h"

#include <algorithm>
#include <unordered_map>

namespace braidx {

Committed commit(const std::vector<Tube>& tubes, ContactElements& elements, Unknowns q,
                 Unknowns q_start, const ContactLaws& laws) {
    Committed out;
    for (auto& element : elements) {
        const Reaction r = reaction(tubes, element, q, q_start, laws);
        out.penetration = std::max(out.penetration, -r.system.gap);
        if (!r.acts()) {
            element.slip.setZero();
            continue;
        }
        if (r.friction.coefficient <= 0)
            continue;
        const Vec3 remembered = r.friction.remembered(r.slip);
        const double work = r.friction_force.dot(r.slip - remembered);
        element.work += work;
        out.work += work;
        element.slip = remembered;
    }
    return out;
}

int adapt_stiffness(const std::vector<Tube>& tubes, ContactElements& elements, Unknowns q,
                    double tolerance, double growth) {
    std::unordered_map<std::int32_t, double> deepest;
    for (const auto& e : elements) {
        auto& d = deepest[e.zone];
        d = std::max(d, -local_system(tubes, e, q).gap);
    }
    for (auto& e : elements)
        if (const double ratio = deepest[e.zone] / tolerance; ratio > 1)
            e.stiffness *= std::min(growth, 1.2 * ratio);
    return static_cast<int>(
        std::ranges::count_if(deepest, [&](const auto& d) { return d.second > tolerance; }));
}

} // namespace braidx
