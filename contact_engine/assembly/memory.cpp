#include "memory.h"

#include "../parallel.h"
#include "energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace braidx {

namespace {

/// What happens to one contact element.
Committed commit(const DeformableSurfaces& surfaces, ContactElement& element, Unknowns q,
                 Unknowns q_start, const ContactLaws& laws) {
    const Reaction r = reaction(surfaces, element, q, q_start, laws);
    Committed out{0, std::max(0.0, -r.system.gap)};
    if (!r.acts()) {
        element.slip.setZero();
    } else if (r.friction.coefficient > 0) {
        element.slip = r.friction.remembered(r.slip);
        out.work = r.friction_force.dot(r.slip - element.slip);
        element.work += out.work;
    } else {
        element.slip = element.turn * element.slip;
    }
    element.turn.setIdentity(); // the next increment starts here
    element.wall_start = element.wall;
    return out;
}

std::vector<double> gaps(const DeformableSurfaces& surfaces, const ContactElements& elements,
                         Unknowns q, int num_threads) {
    return parallel_map(elements.size(), num_threads,
                        [&](std::size_t e) { return local_system(surfaces, elements[e], q).gap; });
}

} // namespace

Committed commit(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                 Unknowns q_start, const ContactLaws& laws, int num_threads) {
    const auto each = parallel_map(elements.size(), num_threads, [&](std::size_t e) {
        return commit(surfaces, elements[e], q, q_start, laws);
    });
    Committed out;
    for (const auto& one : each) {
        out.work += one.work;
        out.penetration = std::max(out.penetration, one.penetration);
    }
    return out;
}

namespace {

/// Factor beyond the penalty that would just do: forces grow from increment to increment, and each
/// raise costs a new equilibrium.
constexpr double headroom = 1.6;
/// Zones that come this close to the tolerance are raised with those beyond it.
constexpr double soon = 0.6;
/// Share of the derivative of the gap, as a square, that unknowns which can move have on one side
/// at least where a penalty is of use.
constexpr double movable = 0.75;

bool can_open(const LocalSystem& system, std::span<const bool> held) {
    std::array<double, 2> free{}, all{};
    for (int i = 0; i < system.count; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const auto n = static_cast<std::size_t>(i);
            const double weight = system.gap_weight[n][axis];
            const std::size_t side = system.of_b[n] ? 1 : 0;
            all[side] += weight * weight;
            if (!held[static_cast<std::size_t>(system.unknown[n] + axis)])
                free[side] += weight * weight;
        }
    return free[0] > movable * all[0] || free[1] > movable * all[1];
}

} // namespace

int adapt_stiffness(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                    double tolerance, double growth, double elsewhere, int num_threads,
                    std::span<const bool> held) {
    const auto gap = parallel_map(elements.size(), num_threads, [&](std::size_t e) {
        const LocalSystem system = local_system(surfaces, elements[e], q);
        return held.empty() || can_open(system, held) ? system.gap : 0.0;
    });
    std::unordered_map<std::int32_t, double> deepest;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        auto& d = deepest[elements[e].zone];
        d = std::max(d, -gap[e]);
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

void update_multipliers(const DeformableSurfaces& surfaces, ContactElements& elements, Unknowns q,
                        Unknowns q_start, const ContactLaws& laws, int num_threads) {
    const auto forces = normal_forces(surfaces, elements, q, q_start, laws, num_threads);
    for (std::size_t e = 0; e < elements.size(); ++e)
        elements[e].multiplier = forces[e] / elements[e].weight;
}

double deepest_penetration(const DeformableSurfaces& surfaces, const ContactElements& elements,
                           Unknowns q, int num_threads) {
    double deepest = 0;
    for (const double gap : gaps(surfaces, elements, q, num_threads))
        deepest = std::max(deepest, -gap);
    return deepest;
}

NormalForces sum_normal_forces(const DeformableSurfaces& surfaces, const ContactElements& elements,
                               Unknowns q, Unknowns q_start, const ContactLaws& laws,
                               int num_threads) {
    const auto force = normal_forces(surfaces, elements, q, q_start, laws, num_threads);
    NormalForces out;
    for (std::size_t e = 0; e < elements.size(); ++e) {
        out.all += force[e];
        if (against_rigid(elements[e]))
            out.rigid += force[e];
    }
    return out;
}

LogStiffness sum_log_stiffness(const ContactElements& elements, bool per_area) {
    LogStiffness out;
    for (const auto& e : elements)
        if (is_per_area(e) == per_area) {
            out.sum += std::log(e.stiffness);
            ++out.count;
        }
    return out;
}

void scale_stiffness(ContactElements& elements, double factor) {
    for (auto& e : elements) {
        e.stiffness *= factor;
        e.multiplier *= factor;
    }
}

} // namespace braidx
