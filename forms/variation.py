"""First and second variation of a stored energy, one set of forms per quadrature."""

from typing import NamedTuple

import ufl

from .curve import Part, integral


class Variation(NamedTuple):
    """Energy, its gradient and its Hessian for one quadrature."""

    energy: ufl.Form  # mJ
    residual: ufl.Form  # mJ per unit of the unknowns
    tangent: ufl.Form


def variations(
    parts: list[Part], unknowns: ufl.Coefficient, foreseen: list[Part] | None = None
) -> list[Variation]:
    """Derive the forms of every part; quadratures are never mixed in one form (see `Part`).

    Args:
        parts: Energy densities with their quadratures.
        unknowns: The field to derive by.
        foreseen: Energies whose Hessian is the tangent, if not that of `parts` itself; part by part.
    """
    space = unknowns.ufl_function_space()
    test, trial = ufl.TestFunction(space), ufl.TrialFunction(space)
    result = []
    for part, other in zip(parts, foreseen or parts):
        energy = integral(part, space.ufl_domain())
        gradient = ufl.derivative(integral(other, space.ufl_domain()), unknowns, test)
        tangent = ufl.derivative(gradient, unknowns, trial)
        result.append(Variation(energy, ufl.derivative(energy, unknowns, test), tangent))
    return result
