#include "memory.h"

#include <algorithm>
#include <cmath>
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

namespace {

/// Factor beyond the penalty that would just do: forces grow from increment to increment, and each
/// raise costs a new equilibrium.
constexpr double headroom = 1.6;
/// Zones that come this close to the tolerance are raised with those beyond it.
constexpr double soon = 0.6;

} // namespace

int adapt_stiffness(const std::vector<Tube>& tubes, ContactElements& elements, Unknowns q,
                    double tolerance, double growth, double elsewhere) {
    std::unordered_map<std::int32_t, double> deepest;
    for (const auto& e : elements) {
        auto& d = deepest[e.zone];
        d = std::max(d, -local_system(tubes, e, q).gap);
    }
    const auto count = [&](double limit) {
        return static_cast<int>(
            std::ranges::count_if(deepest, [&](const auto& d) { return d.second > limit; }));
    };
    if (elsewhere <= tolerance && count(tolerance) == 0)
        return 0;
    for (auto& e : elements)
        if (const double ratio = deepest[e.zone] / tolerance; ratio > soon)
            e.stiffness *= std::min(growth, headroom * ratio);
    return count(soon * tolerance);
}

double deepest_penetration(const std::vector<Tube>& tubes, const ContactElements& elements,
                           Unknowns q) {
    double deepest = 0;
    for (const auto& e : elements)
        deepest = std::max(deepest, -local_system(tubes, e, q).gap);
    return deepest;
}

double sum_log_stiffness(const ContactElements& elements) {
    double sum = 0;
    for (const auto& e : elements)
        sum += std::log(e.stiffness);
    return sum;
}

void scale_stiffness(ContactElements& elements, double factor) {
    for (auto& e : elements)
        e.stiffness *= factor;
}

} // namespace braidx
