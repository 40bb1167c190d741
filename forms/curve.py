"""Calculus along a curve, and the parts that a stored energy is summed from."""

from typing import Any, NamedTuple

import ufl


class Part(NamedTuple):
    """A term of the stored energy with its own quadrature.

    Each part is compiled into forms of its own: FFCx 0.9 assembles wrong matrices when one form
    mixes quadratures, so they never meet in a form and the assembled parts are added.
    """

    density: Any  # energy per reference length, N (= mJ / mm), or volume, MPa (= mJ / mm^3)
    quadrature_degree: int
    quadrature_rule: str = "default"  # Gauss; "GLL" has its points at the nodes; "custom": own ones
    points: tuple[tuple[float, ...], ...] = ()  # in the reference cell
    weights: tuple[float, ...] = ()


def gauss(density: Any, num_points: int) -> Part:
    """Integrate with `num_points` Gauss points per element."""
    return Part(density, 2 * num_points - 1)


def nodal(density: Any, degree: int) -> Part:
    """Integrate with the nodes of elements of `degree` 1 or 2 as points (Gauss-Lobatto)."""
    return Part(density, 2 * degree - 1, "GLL")


def integral(part: Part, mesh: ufl.Mesh) -> ufl.Form:
    """Integral of a part over the reference configuration, mJ."""
    quadrature: dict[str, Any] = {
        "quadrature_degree": part.quadrature_degree,
        "quadrature_rule": part.quadrature_rule,
    }
    if part.points:
        quadrature |= {"quadrature_points": part.points, "quadrature_weights": part.weights}
    return part.density * ufl.dx(domain=mesh, metadata=quadrature)


def unit_tangent(mesh: ufl.Mesh) -> Any:
    """Unit tangent T of the reference curve, which is the geometry of `mesh`; shape (3,)."""
    jacobian = ufl.Jacobian(mesh)
    direction = ufl.as_vector([jacobian[i, 0] for i in range(3)])
    return direction / ufl.sqrt(ufl.dot(direction, direction))


def arc_derivative(field: Any, tangent: Any) -> Any:
    """Derivative of a vector field by the reference arc length; same shape as `field`, per mm."""
    return ufl.dot(ufl.grad(field), tangent)
