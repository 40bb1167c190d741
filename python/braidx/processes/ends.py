"""The two end sections of a sample (paper 1, 2.4 and 3.4.3): what is held, tied, prescribed."""

from __future__ import annotations

import numpy as np

from ..bodies import CurveBody
from ..scene import EndConditions
from ..system.constraints import ConstraintMap, Constraints, Floats


class Ends:
    """Constraints on the first and the last node of each yarn.

    Axially the first section stays and the last one is moved as one plane. Across, each yarn's last
    node follows its first (periodic), both stay (fixed), or are free.
    """

    def __init__(self, body: CurveBody, options: EndConditions) -> None:
        block, nodes = body.block, body.layout.curves
        self._rest = body.rest.ravel().copy()
        self._options = options
        self._first, self._last = nodes[:-1] * block, (nodes[1:] - 1) * block
        self._block = block
        self.last_axial = self._last + 2
        self.length = float(self._rest[self.last_axial].mean() - self._rest[self._first + 2].mean())

        constraints, self._values = self._across()
        for section in (self._first + 2, self.last_axial):
            constraints.hold(section)
            self._values[section] = self._rest[section]
        self._map = constraints.resolve()

    def held(self, strain: float) -> tuple[ConstraintMap, Floats]:
        """Both end sections held, the last one at a rope strain from the reference state.

        Returns:
            The constraint map and the values of its constraints, mm.
        """
        values = self._values.copy()
        values[self.last_axial] += strain * self.length
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
