#pragma once

#include "assembly/assemble.h"
#include "assembly/energy.h"
#include "support/rods.h"

namespace braidx::test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Rods with contact elements between them, and the start of the increment.
struct Contact {
    Rods rods;
    ContactElements elements;
    std::vector<double> start; ///< unknowns at the start of the increment
    ContactLaws laws;

    Vector residual() const { return residual(rods.q); }
    Vector residual(const std::vector<double>& q, int num_threads = 1) const;
    Matrix tangent(FrictionTangent tangent, int num_threads = 1) const;

    /// Potential of the contact forces, with the normal forces at `rods.q` in friction.
    double energy(const std::vector<double>& q) const;
    Matrix finite_difference_tangent(double step = 1e-6) const;
    Vector finite_difference_gradient(double step = 1e-6) const;
};

/// Friction `mu` between all bodies.
ContactLaws laws_with(double mu, int num_bodies = 2);

/// Two randomly deformed tubes with random contact elements between them, all of them in
/// penetration (some in the quadratic part of the law, some in the linear one); `slide` (mm) is the
/// motion of the increment.
Contact random_contact(const Kind& kind_a, const Kind& kind_b, double mu, double slide,
                       unsigned seed);

/// Contact elements of a small tangle: three kinds of tubes, walls, one tube against itself.
Contact mixed_contacts();

/// One randomly deformed tube against walls.
Contact random_contact_with_wall(const Kind& kind, double mu, double slide, unsigned seed);

} // namespace braidx::test
