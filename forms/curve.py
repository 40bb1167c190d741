"""Calculus along a curve, and the parts that a stored energy is summed from."""

from typing import Any, NamedTuple

import ufl


class Part(NamedTuple):
    """A term of the stored energy with its own quadrature degree.

    Each part is compiled into forms of its own: FFCx 0.9 assembles wrong matrices when one form
    mixes quadrature degrees, so degrees never meet in a form and the assembled parts are added.
    """

    density: Any  # energy per reference length, N (= mJ / mm)
    quadrature_degree: int


def measure(mesh: ufl.Mesh, quadrature_degree: int) -> ufl.Measure:
    """Integration along the reference curve, mm."""
    return ufl.dx(domain=mesh, metadata={"quadrature_degree": quadrature_degree})


def unit_tangent(mesh: ufl.Mesh) -> Any:
    """Unit tangent T of the reference curve, which is the geometry of `mesh`; shape (3,)."""
    jacobian = ufl.Jacobian(mesh)
    direction = ufl.as_vector([jacobian[i, 0] for i in range(3)])
    return direction / ufl.sqrt(ufl.dot(direction, direction))


def arc_derivative(field: Any, tangent: Any) -> Any:
    """Derivative of a vector field by the reference arc length; same shape as `field`, per mm."""
    return ufl.dot(ufl.grad(field), tangent)
