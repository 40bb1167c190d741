"""Cable: a curve that resists stretching only.

Three unknowns per node, the current position x. With the stretch lambda = |x'|,

    W = T0 (lambda - 1) + 1/2 EA (lambda - 1)^2        per reference length,
    T = T0 + EA (lambda - 1).

T0 > 0 keeps the tangent positive definite, also transversely: the model for form-finding.
"""

from typing import Any

import ufl

from .curve import Part, arc_derivative, gauss


def _stretch(position: Any, tangent: Any) -> Any:
    slope = arc_derivative(position, tangent)
    return ufl.sqrt(ufl.dot(slope, slope))


def energy(
    position: Any, tangent: Any, axial_stiffness: Any, tension: Any, degree: int
) -> list[Part]:
    """Stored energy of a cable.

    Args:
        position: Current position, shape (3,), mm.
        tangent: Unit tangent of the reference curve, shape (3,).
        axial_stiffness: EA, N.
        tension: Tension T0 in the reference configuration, N.
        degree: Degree of the line elements, 1 or 2.
    """
    strain = _stretch(position, tangent) - 1.0
    return [gauss(tension * strain + 0.5 * axial_stiffness * strain**2, num_points=degree)]


def axial_force(position: Any, tangent: Any, axial_stiffness: Any, tension: Any) -> Any:
    """Tension of the cable, N, positive when pulled; arguments as in `energy`."""
    return tension + axial_stiffness * (_stretch(position, tangent) - 1.0)
