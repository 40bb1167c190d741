#include "local_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace braidx {
namespace {

/// A side of a contact element: the section of a tube at s, or a place on a facet of a skin.
struct Side {
    const DeformableSurfaces& surfaces;
    std::int32_t surface, facet;
    double s;
    const double (&xi)[2];
    double round;
    bool of_b;

    Side(const DeformableSurfaces& all, const ContactElement& e, bool is_b)
        : surfaces(all), surface(is_b ? e.surface_b : e.surface_a),
          facet(is_b ? e.facet_b : e.facet_a), s(is_b ? e.s_b : e.s_a), xi(is_b ? e.xi_b : e.xi_a),
          round(is_b ? e.round_b : e.round_a), of_b(is_b) {}

    double sign() const { return of_b ? 1 : -1; }
};

/// Adds a vector unknown with its weight in a side's material particle.
void add_unknown(LocalSystem& system, std::int64_t unknown, double weight, bool of_b, Unknowns q) {
    assert(system.count < LocalSystem::capacity);
    const int i = system.count++;
    system.unknown[i] = unknown;
    system.of_b[i] = of_b;
    system.gap_weight[i].setZero();
    system.slip_weight[i] = weight;
    system.separation += weight * vector_at(q, unknown);
}

/// Adds a place on a facet, which is the particle and the part of the gap at once.
void add_facet(LocalSystem& system, const Side& side, Unknowns q) {
    const Skin& skin = side.surfaces.skin(side.surface);
    const auto weights = facet_weights(skin.kind, side.xi[0], side.xi[1]);
    const Vec3& normal = system.facing.normal;
    for (int n = 0; n < skin.nodes_per_facet(); ++n) {
        const auto unknown = skin.unknown_of(side.facet, n);
        const double weight = side.sign() * weights.value[static_cast<std::size_t>(n)];
        add_unknown(system, unknown, weight, side.of_b, q);
        system.gap_weight[system.count - 1] = weight * normal;
        system.gap += weight * normal.dot(vector_at(q, unknown));
    }
}

/// Adds the material particle of a tube, at the element's own section: unknowns in the order of the
/// pattern.
void add_particle(LocalSystem& system, const Side& side, Unknowns q) {
    const Tube& tube = side.surfaces.tube(side.surface);
    const double s = side.s;
    const auto add = [&](std::int64_t unknown, double weight) {
        add_unknown(system, unknown, side.sign() * weight, side.of_b, q);
    };
    const Support centre = contact_support(tube, s);
    for (int i = 0; i < centre.count; ++i)
        add(tube.unknown_of(centre.node[i]), centre.weight[i]);
    if (!tube.has_directors())
        return;
    const Support section = element_support(tube, s);
    for (int which = 0; which < 2; ++which)
        for (int i = 0; i < section.count; ++i)
            add(tube.unknown_of(section.node[i]) + 3 * (which + 1),
                side.xi[which] * section.weight[i]);
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

/// Adds a tube's part of the gap: the centre line at s, where it faces the other side; the half
/// width at the element's own section, at ends as far as the normal is in that section, and the
/// radius for the rest.
void add_gap(LocalSystem& system, const Side& side, double s, Unknowns q) {
    const Tube& tube = side.surfaces.tube(side.surface);
    const bool of_b = side.of_b;
    const Vec3& normal = system.facing.normal;
    const double sign = side.sign();
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
    system.gap -= side.round * tube.radius;
    const Support section = element_support(tube, side.s);
    for (int i = 0; i < section.count; ++i)
        add_half_width(system, tube, section.node[i], (1 - side.round) * section.weight[i], of_b,
                       q);
}

/// Adds the particle of a rigid surface that a frame turns; on the gap its turn has no influence.
void add_in_frame(LocalSystem& system, const ContactElement& e, Unknowns q) {
    add_unknown(system, e.frame, 1, true, q);
    for (int i = 0; i < 3; ++i)
        add_unknown(system, e.frame + 3 * (i + 1), e.in_frame[i], true, q);
}

LocalSystem system_at(const DeformableSurfaces& surfaces, const ContactElement& e, Unknowns q,
                      const Facing& where) {
    LocalSystem system;
    system.facing = where;
    system.own_normal = e.normal;
    system.gap = e.allowance;
    const Side a(surfaces, e, false), b(surfaces, e, true);
    const bool rigid = against_rigid(e);
    const auto add_side = [&](const Side& side) {
        if (side.facet >= 0)
            add_facet(system, side, q);
        else
            add_particle(system, side, q);
    };
    add_side(a);
    system.count_a = system.count;
    if (!rigid)
        add_side(b);
    else if (e.frame >= 0)
        add_in_frame(system, e, q);
    system.count_frozen = system.count;
    if (a.facet < 0)
        add_gap(system, a, where.s_a, q);
    if (rigid) {
        system.gap += e.normal.dot(e.wall);
        if (e.frame < 0)
            system.separation += e.wall;
    } else if (b.facet < 0) {
        add_gap(system, b, where.s_b, q);
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
        assert(count < capacity);
        unknown[index] = number;
        of_b[index] = belongs_to_b;
        gap_weight[index].setZero();
        ++count;
    }
    return index;
}

LocalSystem local_system(const DeformableSurfaces& surfaces, const ContactElement& e, Unknowns q) {
    return system_at(surfaces, e, q, facing(surfaces, e, q));
}

LocalSystem frozen_system(const DeformableSurfaces& surfaces, const ContactElement& e, Unknowns q) {
    return system_at(surfaces, e, q, {e.s_a, e.s_b, e.normal, 1, 0});
}

} // namespace braidx
