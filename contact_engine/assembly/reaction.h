#pragma once

#include "../laws/friction_law.h"
#include "../laws/normal_law.h"
#include "local_system.h"

#include <vector>

namespace braidx {

/// Laws of contact between all bodies.
struct ContactLaws {
    double regularisation = 0.004; ///< p_reg, mm
    double reversible_slip = 0.01; ///< g_rev,max, mm
    double gap_step = -1;          ///< gap reduction per increment, mm; negative: off
    bool sliding = true; ///< tangent with the sliding of sections: exact, but not always definite
    int num_bodies = 1;
    std::vector<double> friction; ///< mu of body a against body b, num_bodies x num_bodies

    double coefficient(int body_a, int body_b) const {
        return friction.empty() ? 0.0
                                : friction[static_cast<std::size_t>(body_a * num_bodies + body_b)];
    }
};

/// Reaction of a contact element: normal force R_N on b along N, and friction force R_T on a
/// (opposite on b).
struct Reaction {
    LocalSystem system;
    FrictionLaw friction;
    double stiffness = 0;     ///< -dR_N/dgap, N/mm
    double normal_force = 0;  ///< R_N >= 0, N
    double energy = 0;        ///< of the penalty, N mm
    Vec3 slip = Vec3::Zero(); ///< trial slip: remembered plus that of the increment, mm, as
                              ///< seen by what turns with the pair
    Vec3 friction_force = Vec3::Zero();

    /// One that is not a number acts: the residual then tells that a state diverged.
    bool acts() const { return !(normal_force <= 0); }
};

/// Reaction at q; q_start is the configuration at the start of the increment.
Reaction reaction(const DeformableSurfaces& surfaces, const ContactElement& element, Unknowns q,
                  Unknowns q_start, const ContactLaws& laws);

} // namespace braidx
