"""The two end sections of a sample (paper 1, 2.4 and 3.4.3): what is held, tied, prescribed."""

from __future__ import annotations

import numpy as np

from ..bodies import CurveBody
from ..geometry import Rotations
from ..scene import EndConditions
from ..system.constraints import ConstraintMap, Constraints, Floats


class Ends:
    """Constraints on the first and the last node of each yarn.

    Axially the first section stays and the last one is moved as one plane. Across, each yarn's last
    node follows its first (periodic), both stay (fixed), or are free. Where the rope is kept
    symmetric, yarns follow the one that they are images of, from end to end (cables only).
    """

    def __init__(
        self, body: CurveBody, options: EndConditions, symmetry: Rotations | None = None
    ) -> None:
        block, nodes = body.block, body.layout.curves
        self._rest = body.rest.ravel().copy()
        self._options = options
        self._first, self._last = nodes[:-1] * block, (nodes[1:] - 1) * block
        self._block = block
        self.last_axial = self._last + 2
        self.length = float(self._rest[self.last_axial].mean() - self._rest[self._first + 2].mean())

        yarns = np.arange(len(nodes) - 1)
        leads = yarns == symmetry.leader if symmetry else np.full(len(yarns), True)
        self._first, self._last = self._first[leads], self._last[leads]
        constraints, self._values = self._across()
        for section in (self._first + 2, self._last + 2):
            constraints.hold(section)
            self._values[section] = self._rest[section]
        if symmetry:
            _turn(constraints, symmetry, nodes)
        self._map = constraints.resolve()

    def held(self, strain: float) -> tuple[ConstraintMap, Floats]:
        """Both end sections held, the last one at a rope strain from the reference state.

        Returns:
            The constraint map and the values of its constraints, mm.
        """
        values = self._values.copy()
        values[self._last + 2] += strain * self.length
        return self._map, values

    def _across(self) -> tuple[Constraints, Floats]:
        constraints, values = Constraints(len(self._rest)), np.zeros(len(self._rest))
        first, last = self._nodal(self._first), self._nodal(self._last)
        if self._options.transverse == "periodic":
            constraints.tie(last, first)
            values[last] = self._rest[last] - self._rest[first]
        elif self._options.transverse == "fixed":
            for section in (first, last):
                constraints.hold(section)
                values[section] = self._rest[section]
        return constraints, values

    def _nodal(self, first_unknown: np.ndarray) -> np.ndarray:
        """Unknowns of end nodes that move across the axis: x, y, and directors where those are not free."""
        components = [0, 1]
        if self._block > 3 and self._options.sections == "fixed":
            components += range(3, self._block)
        return (first_unknown[:, None] + np.array(components)).ravel()


def _turn(constraints: Constraints, symmetry: Rotations, nodes: np.ndarray) -> None:
    """Ties yarns of three unknowns per node to those that they are images of."""
    for yarn in np.flatnonzero(symmetry.leader != np.arange(len(nodes) - 1)):
        angle = 2.0 * np.pi * symmetry.turns[yarn] / symmetry.fold
        first, leader = nodes[yarn], nodes[symmetry.leader[yarn]]
        x = 3 * np.arange(first, nodes[yarn + 1])
        x_leader = x + 3 * (leader - first)
        across = np.column_stack([x_leader, x_leader + 1])
        constraints.combine_each(x, across, [np.cos(angle), -np.sin(angle)])
        constraints.combine_each(x + 1, across, [np.sin(angle), np.cos(angle)])
        constraints.tie(x + 2, x_leader + 2)
        constraints.repeat(np.concatenate([x, x + 1, x + 2]))
