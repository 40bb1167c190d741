#pragma once

#include "pattern.h"
#include "reaction.h"

#include <span>

namespace braidx {

/// Which tangent of friction: the exact one, not symmetric, or its symmetric part without the
/// coupling to R_N.
enum class FrictionTangent { consistent, symmetric };

/// Adds the contact forces' residual (the gradient of the energy: minus the forces on the unknowns,
/// N). Contact elements between images are left out, so that rows of images are incomplete.
void add_residual(const DeformableSurfaces& surfaces, const ContactElements& elements, Unknowns q,
                  Unknowns q_start, const ContactLaws& laws, std::span<double> residual,
                  int num_threads = 1);

/// Adds the derivative of the residual to the blocks of the pattern, nine values per block, row by
/// row.
void add_tangent(const DeformableSurfaces& surfaces, const ContactElements& elements,
                 const Pattern& pattern, Unknowns q, Unknowns q_start, const ContactLaws& laws,
                 FrictionTangent tangent, std::span<double> values, int num_threads = 1);

} // namespace braidx
