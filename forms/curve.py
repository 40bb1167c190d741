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


class Nodes(NamedTuple):
    """Nodes of an element that lie alike, as points of its Gauss-Lobatto rule."""

    points: tuple[float, ...]  # in the reference cell, 0 to 1
    weight: float  # of each
    beyond_gauss: float  # squared distance from the middle, less that of the points of `gauss`


LIKE_NODES = {
    1: (Nodes((0.0, 1.0), 1.0 / 2.0, 1.0 / 4.0),),
    2: (Nodes((0.0, 1.0), 1.0 / 6.0, 1.0 / 6.0), Nodes((0.5,), 2.0 / 3.0, -1.0 / 12.0)),
}


def at_nodes(density: Any, nodes: Nodes) -> Part:
    """Share of `nodal` that is integrated at some of the nodes."""
    points = tuple((at,) for at in nodes.points)
    return Part(density, 1, "custom", points, (nodes.weight,) * len(points))


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


def change_of_slope(field: Any, tangent: Any) -> Any:
    """Change of a field's derivative by arc length from one end of an element to the other, same shape as `field`.

    Constant in elements of degree 2 whose middle node is in the middle, zero for degree 1.
    """
    jacobian = ufl.Jacobian(ufl.domain.extract_unique_domain(tangent))
    bend = ufl.dot(ufl.dot(ufl.grad(ufl.grad(field)), tangent), tangent)
    return ufl.sqrt(ufl.inner(jacobian, jacobian)) * bend
