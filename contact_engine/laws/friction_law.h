#pragma once

#include "../types.h"

namespace braidx {

/// Regularised friction (paper 1, eq. 5): reversible up to reversible_slip, sliding beyond.
struct FrictionLaw {
    double coefficient;     ///< mu
    double reversible_slip; ///< g_rev,max, mm

    bool slides(const Vec3& slip) const {
        return slip.squaredNorm() > reversible_slip * reversible_slip;
    }

    /// Traction on a (opposed on b) per unit of normal force, for the tangential slip of b against
    /// a.
    Vec3 direction(const Vec3& slip) const {
        return coefficient * slip / (slides(slip) ? slip.norm() : reversible_slip);
    }

    /// Potential of `direction`, mm: quadratic up to the reversible slip, linear beyond.
    double potential(const Vec3& slip) const {
        const double norm = slip.norm();
        return coefficient *
               (slides(slip) ? norm - 0.5 * reversible_slip : 0.5 * norm * norm / reversible_slip);
    }

    /// Derivative of `direction` with the slip; `plane` = I - N N^T.
    Mat3 direction_gradient(const Vec3& slip, const Mat3& plane) const {
        if (!slides(slip))
            return coefficient / reversible_slip * plane;
        const double norm = slip.norm();
        const Vec3 along = slip / norm;
        return coefficient / norm * (plane - along * along.transpose());
    }

    /// What the contact remembers of a slip: the reversible part.
    Vec3 remembered(const Vec3& slip) const {
        return slides(slip) ? Vec3(slip * (reversible_slip / slip.norm())) : slip;
    }
};

} // namespace braidx
