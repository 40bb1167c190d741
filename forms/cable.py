"""Cable: a curve that resists stretching only.

Three unknowns per node, the current position x. With the stretch lambda = |x'| and the force L = T0 + EA (lambda - 1)
of an elastic bar, T0 being the tension of the reference configuration, the tension T and the energy W per reference
length are

    T = max(L, 0),  W = T^2 / (2 EA).

A yarn of thousands of filaments buckles instead of being compressed. T >= 0 keeps the second derivative of W positive
semidefinite, also transversely. It has no inverse where a cable has no tension: the tangent of Newton's method is that
of a cable with a small stiffness more (`supported`), which acts on the way to an equilibrium and not in it.
"""

from typing import Any

import ufl

from .curve import Part, arc_derivative, gauss

# Stiffness of all cables in the tangent alone, over EA. It is large enough for a linear solve, whose condition is then
# 1e9 at most and leaves seven digits of a step, and small enough not to be felt: at a tension of 1e-6 EA a step is
# wrong by a thousandth.
SUPPORT = 1e-9


def _slope_and_force(
    position: Any, tangent: Any, axial_stiffness: Any, tension: Any
) -> tuple[Any, Any]:
    """Slope x', and the force of an elastic bar."""
    slope = arc_derivative(position, tangent)
    return slope, tension + axial_stiffness * (ufl.sqrt(ufl.dot(slope, slope)) - 1.0)


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
    now = axial_force(position, tangent, axial_stiffness, tension)
    return [gauss((now**2 - tension**2) / (2.0 * axial_stiffness), num_points=degree)]


def supported(
    position: Any, tangent: Any, axial_stiffness: Any, tension: Any, degree: int
) -> list[Part]:
    """Energy whose Hessian is the tangent, arguments as in `energy`.

    It is that of `energy` with the stiffness SUPPORT in all directions. A cable counts as taut down to a strain of half
    of SUPPORT below zero: round-off does not decide about cables that are placed without tension, and the sum of the
    bar's force and the support stays positive.
    """
    slope, force = _slope_and_force(position, tangent, axial_stiffness, tension)
    taut = ufl.gt(force, -0.5 * SUPPORT * axial_stiffness)
    bar = ufl.conditional(taut, force**2 / (2.0 * axial_stiffness), 0.0)
    return [gauss(bar + 0.5 * SUPPORT * axial_stiffness * ufl.dot(slope, slope), num_points=degree)]


def axial_force(position: Any, tangent: Any, axial_stiffness: Any, tension: Any) -> Any:
    """Tension of the cable, N, not negative; arguments as in `energy`."""
    _, force = _slope_and_force(position, tangent, axial_stiffness, tension)
    return ufl.max_value(force, 0.0)
