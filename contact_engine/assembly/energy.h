#pragma once

#include "reaction.h"

#include <span>

namespace braidx {

/// Normal force R_N of each contact element, N.
std::vector<double> normal_forces(const DeformableSurfaces& surfaces,
                                  const ContactElements& elements, Unknowns q, Unknowns q_start,
                                  const ContactLaws& laws, int num_threads = 1);

/// Potential of the contact forces, N mm, whose gradient is the residual of `add_residual`.
///
/// Friction has none; with normal forces that stay as they are it has (FrictionLaw::potential).
/// The gradient is therefore exact without friction, and where q has the normal forces `lagged`,
/// one per contact element. Of contact elements with an image, which occur twice, half counts.
double contact_energy(const DeformableSurfaces& surfaces, const ContactElements& elements,
                      Unknowns q, Unknowns q_start, const ContactLaws& laws,
                      std::span<const double> lagged, int num_threads = 1);

} // namespace braidx
