#include "local_system.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

/// Adds a side's material particle, at the element's own section: unknowns in the order of the
/// pattern.
void add_particle(LocalSystem& system, const Tube& tube, double s, const double (&xi)[2], bool of_b,
                  Unknowns q) {
    const double sign = of_b ? 1 : -1;
    const auto add = [&](std::int64_t unknown, double weight) {
        const int i = system.count++;
        system.unknown[i] = unknown;
        system.of_b[i] = of_b;
        system.gap_weight[i].setZero();
        system.slip_weight[i] = sign * weight;
        system.separation += sign * weight * vector_at(q, unknown);
    };
    const Support centre = contact_support(tube, s);
    for (int i = 0; i < centre.count; ++i)
        add(tube.unknown_of(centre.node[i]), centre.weight[i]);
    if (!tube.has_directors())
        return;
    const Support section = element_support(tube, s);
    for (int which = 0; which < 2; ++which)
        for (int i = 0; i < section.count; ++i)
            add(tube.unknown_of(section.node[i]) + 3 * (which + 1), xi[which] * section.weight[i]);
}

/// Adds a node's share of the half width of a beam's section.
void add_half_width(LocalSystem& system, const Tube& tube, std::int32_t node, double share,
                    bool of_b, Unknowns q) {
    const auto first = tube.unknown_of(node);
    auto& section = system.sections[system.num_sections++];
    section.share = share * tube.radius;
    section.half_width =
        half_width({vector_at(q, first + 3), vector_at(q, first + 6)}, system.own_normal);
    system.gap -= section.share * section.half_width.value;
    for (int which = 0; which < 2; ++which) {
        const int at = section.director[which] = system.index_of(first + 3 * (which + 1), of_b);
        system.gap_weight[at] -= section.share * section.half_width.gradient[which];
    }
}

/// Adds a side's part of the gap: the centre line at s, where it faces the other side; the half
/// width at the element's own section, own_s.
void add_gap(LocalSystem& system, const Tube& tube, double s, double own_s, bool of_b, Unknowns q) {
    const Vec3& normal = system.facing.normal;
    const double sign = of_b ? 1 : -1;
    const Support centre = contact_support(tube, s);
    for (int i = 0; i < centre.count; ++i) {
        const auto unknown = tube.unknown_of(centre.node[i]);
        system.gap_weight[system.index_of(unknown, of_b)] += sign * centre.weight[i] * normal;
        system.gap += sign * centre.weight[i] * normal.dot(vector_at(q, unknown));
    }
    if (!tube.has_directors()) {
        system.gap -= tube.radius;
        return;
    }
    const Support section = element_support(tube, own_s);
    for (int i = 0; i < section.count; ++i)
        add_half_width(system, tube, section.node[i], section.weight[i], of_b, q);
}

LocalSystem system_at(const std::vector<Tube>& tubes, const ContactElement& e, Unknowns q,
                      const Facing& where) {
    LocalSystem system;
    system.facing = where;
    system.own_normal = e.normal;
    system.gap = e.allowance;
    const Tube& a = tubes[e.tube_a];
    add_particle(system, a, e.s_a, e.xi_a, false, q);
    system.count_a = system.count;
    if (!against_rigid(e))
        add_particle(system, tubes[e.tube_b], e.s_b, e.xi_b, true, q);
    system.count_frozen = system.count;
    add_gap(system, a, where.s_a, e.s_a, false, q);
    if (against_rigid(e)) {
        system.gap += e.normal.dot(e.wall);
        system.separation += e.wall;
    } else {
        add_gap(system, tubes[e.tube_b], where.s_b, e.s_b, true, q);
    }
    return system;
}

} // namespace

int LocalSystem::find(std::int64_t number) const {
    return static_cast<int>(std::find(unknown.begin(), unknown.begin() + count, number) -
                            unknown.begin());
}

int LocalSystem::index_of(std::int64_t number, bool belongs_to_b) {
    const int index = find(number);
    if (index == count) {
        unknown[index] = number;
        of_b[index] = belongs_to_b;
        gap_weight[index].setZero();
        ++count;
    }
    return index;
}

LocalSystem local_system(const std::vector<Tube>& tubes, const ContactElement& e, Unknowns q) {
    return system_at(tubes, e, q, facing(tubes, e, q));
}

LocalSystem frozen_system(const std::vector<Tube>& tubes, const ContactElement& e, Unknowns q) {
    return system_at(tubes, e, q, {e.s_a, e.s_b, e.normal, 1, 0});
}

} // namespace braidx
