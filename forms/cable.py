"""Cable: a curve that resists stretching only.

Three unknowns per node, the current position x. With the stretch lambda = |x'| and the force L = L0 + EA (lambda - 1)
of an elastic bar, L0 such that T is T0 in the reference configuration, the tension T and the energy W per reference
length are

    T = L,               W = (L^2 / 2 + S^2 / 6) / EA    where L > S,
    T = (L + S)^2 / 4 S, W = (L + S)^3 / (12 S EA)       in between, S = SLACK EA,
    T = 0,               W = 0                           where L < -S.

A yarn of thousands of filaments buckles instead of being compressed. T >= 0 keeps the tangent positive
semidefinite, also transversely.
"""

from typing import Any

import ufl

from .curve import Part, arc_derivative, gauss

SLACK = 1e-4  # strain about zero over which the tension fades out


def _stretch(position: Any, tangent: Any) -> Any:
    slope = arc_derivative(position, tangent)
    return ufl.sqrt(ufl.dot(slope, slope))


def _rest_force(axial_stiffness: Any, tension: Any) -> Any:
    """Force of the bar at which the tension is `tension`."""
    slack = SLACK * axial_stiffness
    fading = 2.0 * ufl.sqrt(slack * tension) - slack
    return ufl.conditional(ufl.gt(tension, slack), tension, fading)


def _bar_force(position: Any, tangent: Any, axial_stiffness: Any, tension: Any) -> Any:
    stretched = axial_stiffness * (_stretch(position, tangent) - 1.0)
    return _rest_force(axial_stiffness, tension) + stretched


def _work(force: Any, axial_stiffness: Any) -> Any:
    """Energy at which the bar's force is `force`."""
    slack = SLACK * axial_stiffness
    fading = ufl.max_value(force + slack, 0.0) ** 3 / (12.0 * slack)
    taut = 0.5 * force**2 + slack**2 / 6.0
    return ufl.conditional(ufl.gt(force, slack), taut, fading) / axial_stiffness


def energy(
    position: Any, tangent: Any, axial_stiffness: Any, tension: Any, degree: int
) -> list[Part]:
    """Stored energy of a cable, from the reference configuration on.

    Args:
        position: Current position, shape (3,), mm.
        tangent: Unit tangent of the reference curve, shape (3,).
        axial_stiffness: EA, N, positive.
        tension: T0, tension in the reference configuration, N, not negative.
        degree: Degree of the line elements, 1 or 2.
    """
    force = _bar_force(position, tangent, axial_stiffness, tension)
    rest = _work(_rest_force(axial_stiffness, tension), axial_stiffness)
    density = _work(force, axial_stiffness) - rest
    return [gauss(density, num_points=degree)]


def axial_force(position: Any, tangent: Any, axial_stiffness: Any, tension: Any) -> Any:
    """Tension of the cable, N, not negative; arguments as in `energy`."""
    force, slack = _bar_force(position, tangent, axial_stiffness, tension), SLACK * axial_stiffness
    fading = ufl.max_value(force + slack, 0.0) ** 2 / (4.0 * slack)
    return ufl.conditional(ufl.gt(force, slack), force, fading)
