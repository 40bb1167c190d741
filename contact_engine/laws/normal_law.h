#pragma once

#include <algorithm>
#include <cmath>

namespace braidx {

/// Regularised penalty (paper 1, eq. 4): normal reaction R_N >= 0 against the gap (negative =
/// penetration).
struct NormalLaw {
    double stiffness;      ///< k_c, N/mm
    double regularisation; ///< p_reg, mm: quadratic up to this penetration, linear beyond

    double energy(double gap) const {
        if (gap >= 0)
            return 0;
        if (gap >= -regularisation)
            return -stiffness * gap * gap * gap / (6 * regularisation);
        const double p = -gap, r = regularisation;
        return stiffness * (p * p - p * r + r * r / 3) / 2;
    }

    double force(double gap) const {
        if (gap >= 0)
            return 0;
        if (gap >= -regularisation)
            return stiffness * gap * gap / (2 * regularisation);
        return -stiffness * (gap + 0.5 * regularisation);
    }

    /// Penetration that has a force, mm: the inverse of `force`.
    double penetration(double force) const {
        const double smooth = 0.5 * stiffness * regularisation; // at -regularisation
        return force <= smooth ? std::sqrt(2 * regularisation * std::max(force, 0.0) / stiffness)
                               : force / stiffness + 0.5 * regularisation;
    }

    /// -dR_N/dgap >= 0.
    double tangent(double gap) const {
        return gap >= 0 ? 0 : stiffness * std::min(1.0, -gap / regularisation);
    }
};

/// Gap reduction (paper 1, eq. 6, with the sign its text means): an element that starts an
/// increment at gap_initial < 0 is asked to open by `step` at most. A negative step switches the
/// reduction off.
inline double reduced_gap(double gap, double gap_initial, double step) {
    return step < 0 ? gap : gap - std::min(0.0, gap_initial + step);
}

} // namespace braidx
