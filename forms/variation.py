"""First and second variation of a stored energy, one set of forms per quadrature."""

from typing import NamedTuple

import ufl

from .curve import Part, integral


class Variation(NamedTuple):
    """Energy, its gradient and its Hessian for one quadrature."""

    energy: ufl.Form  # mJ
    residual: ufl.Form  # mJ per unit of the unknowns
    tangent: ufl.Form


def variations(parts: list[Part], unknowns: ufl.Coefficient) -> list[Variation]:
    """Derive the forms of every part; quadratures are never mixed in one form (see `Part`).

    Args:
        parts: Energy densities with their quadratures.
        unknowns: The field to derive by.
    """
    space = unknowns.ufl_function_space()
    test, trial = ufl.TestFunction(space), ufl.TrialFunction(space)
    result = []
    for part in parts:
        energy = integral(part, space.ufl_domain())
        residual = ufl.derivative(energy, unknowns, test)
        result.append(Variation(energy, residual, ufl.derivative(residual, unknowns, trial)))
    return result
