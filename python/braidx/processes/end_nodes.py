"""First and last node of each yarn, and their unknowns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..system.constraints import Floats, Ints


@dataclass(frozen=True)
class EndNodes:
    """The two end sections of yarns of one model.

    Attributes:
        block: Unknowns per node.
        curves: First node of each yarn and the number of nodes, shape (num_yarns + 1,).
        rest: Unknowns of the reference state, shape (num_unknowns,).
    """

    block: int
    curves: Ints
    rest: Floats

    @property
    def first(self) -> Ints:
        """First unknown of each yarn's first node, shape (num_yarns,)."""
        return np.asarray(self.curves[:-1] * self.block)

    @property
    def last(self) -> Ints:
        """First unknown of each yarn's last node, shape (num_yarns,)."""
        return np.asarray((self.curves[1:] - 1) * self.block)

    @property
    def last_axial(self) -> Ints:
        """Unknown z of each yarn's last node, shape (num_yarns,)."""
        return self.last + 2

    @property
    def length(self) -> float:
        """Mean distance of the two sections along the axis in the reference state, mm."""
        return self.distance(self.rest)

    def distance(self, q: Floats) -> float:
        """Mean distance of the two sections along the axis, mm."""
        return float(q[self.last_axial].mean() - q[self.first + 2].mean())
