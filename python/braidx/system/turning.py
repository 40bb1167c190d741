"""Stabilisation of the tangents of cables: a viscous moment against their turning away from the predicted state."""

from __future__ import annotations

import numpy as np

from .terms import Floats, Ints


class Turning:
    """A viscous force on the difference of what two neighbouring nodes have moved by, beyond the prediction.

    A cable does not resist bending, so that its elements may turn to and fro by as much as contact lets them. What
    moves a yarn as a whole is hardly held.

    Attributes:
        viscosity: Moment per radian that an element has turned by, N mm.
    Args:
        first, second: First unknowns of the two nodes of each element, shape (num_elements,).
        length: Their rest lengths, mm, shape (num_elements,).
    """

    def __init__(self, first: Ints, second: Ints, length: Floats) -> None:
        component = np.arange(3)
        self._first = (first[:, None] + component).ravel()
        self._second = (second[:, None] + component).ravel()
        self._weight = np.repeat(1.0 / length**2, 3)
        self.viscosity = 0.0

    def add_forces(self, moved: Floats, forces: Floats) -> None:
        """Adds the forces against a motion, both shape (num_unknowns,), mm and N."""
        turned = self.viscosity * self._weight * self._difference(moved)
        np.add.at(forces, self._second, turned)
        np.add.at(forces, self._first, -turned)

    def pattern(self) -> tuple[Ints, Ints]:
        """Rows and columns of the stiffness, shape (num_entries,) each."""
        a, b = self._first, self._second
        return np.concatenate([a, b, a, b]), np.concatenate([a, b, b, a])

    def values(self) -> Floats:
        """Its entries, N/mm."""
        stiffness = self.viscosity * self._weight
        return np.concatenate([stiffness, stiffness, -stiffness, -stiffness])

    def work(self, moved: Floats, counted: Floats | None = None) -> float:
        """Work that the moment takes on the way of a motion, mJ; of unknowns that count 1, or of all."""
        weight = self._weight if counted is None else self._weight * counted[self._first]
        return float(self.viscosity * weight @ self._difference(moved) ** 2)

    def _difference(self, moved: Floats) -> Floats:
        return moved[self._second] - moved[self._first]
