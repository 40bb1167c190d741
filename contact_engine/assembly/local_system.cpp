#include "local_system.h"

#include <algorithm>
#include <cmath>

namespace braidx {
namespace {

/// Appends the unknowns of one side; sign is -1 for a and +1 for b.
void add_side(LocalSystem& system, const Tube& tube, double s, const double (&xi)[2], const Vec3& normal, double sign,
              Unknowns q) {
    const auto add = [&](std::int64_t unknown, double gap_weight, double slip_weight, double spin_weight) {
        const int i = system.count++;
        system.unknown[i] = unknown;
        system.gap_weight[i] = gap_weight;
        system.slip_weight[i] = slip_weight;
        system.spin_weight[i] = spin_weight;
        const Vec3 value = vector_at(q, unknown);
        system.separation += slip_weight * value;
        return value;
    };
    const Support centre = contact_support(tube, s);
    for (int i = 0; i < centre.count; ++i) {
        const double weight = sign * centre.weight[i];
        system.gap += weight * normal.dot(add(tube.unknown_of(centre.node[i]), weight, weight, 0));
    }
    if (!tube.has_directors()) {
        system.gap -= tube.radius;
        return;
    }
    const Support section = element_support(tube, s);
    const double c1 = director(tube, q, section, 1).dot(normal), c2 = director(tube, q, section, 2).dot(normal);
    const double norm = std::max(std::hypot(c1, c2), 1e-12);
    const double along[2] = {c1 / norm, c2 / norm}, across[2] = {-c2 / norm, c1 / norm};
    system.gap -= tube.radius * norm;
    for (int which = 0; which < 2; ++which)
        for (int i = 0; i < section.count; ++i)
            add(tube.unknown_of(section.node[i]) + 3 * (which + 1), -tube.radius * along[which] * section.weight[i],
                sign * xi[which] * section.weight[i],
                std::sqrt(tube.radius / norm) * across[which] * section.weight[i]);
}

} // namespace

LocalSystem local_system(const std::vector<Tube>& tubes, const ContactElement& element, Unknowns q) {
    LocalSystem system;
    system.gap = element.allowance;
    add_side(system, tubes[element.tube_a], element.s_a, element.xi_a, element.normal, -1, q);
    system.count_a = system.count;
    if (against_rigid(element)) {
        system.gap += element.normal.dot(element.wall);
        system.separation += element.wall;
    } else {
        add_side(system, tubes[element.tube_b], element.s_b, element.xi_b, element.normal, 1, q);
    }
    return system;
}

} // namespace braidx
