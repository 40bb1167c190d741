#include "reaction.h"

namespace braidx {

Reaction reaction(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns q,
                  Unknowns q_start, const ContactLaws& laws) {
    Reaction out{.system = local_system(surfaces, element, q),
                 .friction = {0, laws.reversible_slip}};
    const NormalLaw normal_law{element.stiffness * element.weight, laws.regularisation};
    const double shift =
        element.multiplier > 0 ? normal_law.penetration(element.multiplier * element.weight) : 0;
    double gap = out.system.gap;
    const double mu = laws.coefficient(surfaces.body(element.surface_a), element.body_b);
    const bool may_act = gap < shift, needs_start = may_act && (mu > 0 || laws.gap_step >= 0);
    LocalSystem start;
    if (needs_start)
        start = frozen_system(surfaces, element, q_start);
    if (may_act && laws.gap_step >= 0)
        gap = reduced_gap(gap, start.gap, laws.gap_step);
    out.normal_force = normal_law.force(gap - shift);
    out.stiffness = normal_law.tangent(gap - shift);
    out.energy = normal_law.energy(gap - shift);
    if (!out.acts() || mu <= 0)
        return out;
    out.friction.coefficient = mu;
    const Vec3 prescribed =
        element.frame < 0 ? Vec3(element.wall_start - element.wall) : Vec3::Zero();
    const Vec3 separation_start = start.separation + prescribed;
    const Vec3 slip = out.system.separation + element.turn * (element.slip - separation_start);
    out.slip = slip - element.normal.dot(slip) * element.normal;
    out.friction_force = out.normal_force * out.friction.direction(out.slip);
    return out;
}

} // namespace braidx
