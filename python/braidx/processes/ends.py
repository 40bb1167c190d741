"""The two end sections of a sample (paper 1, 2.4 and 3.4.3): what is held, tied, prescribed."""

from __future__ import annotations

from functools import cached_property
from typing import ClassVar

import numpy as np

from ..bodies import CurveBody
from ..geometry import Rotations
from ..scene import EndConditions
from ..system.constraints import ConstraintMap, Constraints, Floats
from .end_nodes import EndNodes


class Ends:
    """Constraints on the first and the last node of each yarn.

    Axially the first section stays and the last one is moved as one plane. Across, each yarn's last
    node follows its first (periodic), both stay (fixed), or are free. Where the rope goes on past its
    ends, these are no planes: each yarn's last node follows its first along the axis, too, and of the
    first ones only one stays. Where the rope is kept symmetric, yarns follow the one that they are
    images of, from end to end.

    Attributes:
        nodes: The end nodes.
        grouped: Whether groups of ends have conditions of their own.
        periodic: Whether the rope goes on past its ends as it does at the other end.
        length: Of the sample in the state whose end sections are held, mm.

    Args:
        body: The yarns.
        options: What the scene says.
        symmetry: Yarns that follow others.
        at: Unknowns of the state whose end sections are held, shape (num_unknowns,).
        cut: Whether the rope ends there, even if its ends are alike.
        pulled: Whether a force moves the last section instead of its being held axially.
        planar: Whether sections are planes even where the rope goes on.
        gauged: Whether the rope as a whole is kept from rotating about its axis where its ends are alike, which nothing
            else does: friction over the depth of a penetration leaves a moment that would rotate it for ever.
    """

    grouped: ClassVar[bool] = False

    def __init__(
        self,
        body: CurveBody,
        options: EndConditions,
        symmetry: Rotations,
        at: Floats,
        pulled: bool = False,
        cut: bool = False,
        planar: bool = False,
        gauged: bool = False,
    ) -> None:
        self._options = options
        self.periodic = options.transverse == "periodic" and not cut
        self.nodes = EndNodes(body.block, body.layout.curves, at.copy())
        self.length = self.nodes.length

        self._symmetry, self._planar, self._gauged = symmetry, planar, gauged
        leads = symmetry.leader == np.arange(len(symmetry.leader))
        self._first, self._last = self.nodes.first[leads], self.nodes.last[leads]
        self._moved = self._last + 2
        if self.periodic and not planar:
            self._moved = self._moved[:1]
        self._map, self._values = self._resolved(pulled)

    @cached_property
    def pulled(self) -> tuple[ConstraintMap, Floats]:
        """The last section not held axially: a force moves it. The constraint map and the values of its constraints."""
        return self._resolved(pulled=True)

    def strain_of(self, q: Floats) -> float:
        """Rope strain of a state whose last section a force moves."""
        moved = self._moved[0]
        return float((q[moved] - self.nodes.rest[moved]) / self.length)

    def strain(self, q: Floats, asked: float) -> float:
        """Strain of the rope in a state for which the steps asked for one."""
        return asked

    def place(self, q: Floats, strain: float, share: float) -> Floats:
        """The state with its ends where groups want them, see GroupedEnds: as it is."""
        return q

    def carry(self, q: Floats, strain: float, share: float) -> Floats:
        """The state with all yarns moved along with their ends, see GroupedEnds: as it is."""
        return q

    def held(
        self, strain: float, share: float = 0.0, at: Floats | None = None
    ) -> tuple[ConstraintMap, Floats]:
        """Both end sections held, the last one at a rope strain from the state they were held at first.

        Args:
            strain: Rope strain.
            share, at: For groups of ends, see GroupedEnds.
        Returns:
            The constraint map and the values of its constraints, mm.
        """
        values = self._values.copy()
        values[self._moved] += strain * self.length
        return self._map, values

    def _resolved(self, pulled: bool) -> tuple[ConstraintMap, Floats]:
        """The constraint map and the values of its constraints."""
        constraints, values = self._across()
        if self._gauged and self._options.transverse == "periodic":
            self._hold_rotation(constraints)
        if self.periodic and not self._planar:
            self._repeat(constraints, values)
        self._along(constraints, values, pulled)
        symmetry = self._symmetry
        for image in np.flatnonzero(symmetry.leader != np.arange(len(symmetry.leader))):
            self._turn(constraints, symmetry, image)
        return constraints.resolve(), values

    def _across(self) -> tuple[Constraints, Floats]:
        constraints, values = Constraints(len(self.nodes.rest)), np.zeros(len(self.nodes.rest))
        first, last = self._nodal(self._first), self._nodal(self._last)
        if self._options.transverse == "periodic":
            constraints.tie(last, first)
            values[last] = self.nodes.rest[last] - self.nodes.rest[first]
        elif self._options.transverse == "fixed":
            for section in (first, last):
                constraints.hold(section)
                values[section] = self.nodes.rest[section]
        return constraints, values

    def _hold_rotation(self, constraints: Constraints) -> None:
        """The first section does not rotate about the axis in the mean, to first order: one gauge condition."""
        x = self.nodes.rest[self._first]
        y = self.nodes.rest[self._first + 1]
        arms = np.concatenate([-y, x])
        unknowns = np.concatenate([self._first, self._first + 1])
        solved = int(np.argmax(np.abs(arms)))
        others = np.delete(np.arange(len(arms)), solved)
        if abs(arms[solved]) > 0.0:
            constraints.combine(
                int(unknowns[solved]), unknowns[others], -arms[others] / arms[solved]
            )

    def _repeat(self, constraints: Constraints, values: Floats) -> None:
        """All yarns get longer along the axis by what the first one does."""
        first, last = self._first + 2, self._last + 2
        length = self.nodes.rest[last] - self.nodes.rest[first]
        of = np.column_stack([first[1:], np.full((len(last) - 1, 2), [last[0], first[0]])])
        constraints.combine_each(last[1:], of, [1.0, 1.0, -1.0])
        values[last[1:]] = length[1:] - length[0]

    def _along(self, constraints: Constraints, values: Floats, pulled: bool) -> None:
        """What stays along the axis, and what is moved or pulled."""
        last = self._moved
        first = self._first[: len(last)] + 2
        constraints.hold(first)
        values[first] = self.nodes.rest[first]
        if pulled:
            constraints.tie(last[1:], last[0])
            values[last[1:]] = self.nodes.rest[last[1:]] - self.nodes.rest[last[0]]
        else:
            constraints.hold(last)
            values[last] = self.nodes.rest[last]

    def _nodal(self, first_unknown: np.ndarray) -> np.ndarray:
        """Unknowns of end nodes that move across the axis: x, y, and directors where those are not free.

        Nor are they where the rope goes on: yarns would have hinges there.
        """
        components = [0, 1]
        if self.nodes.block > 3 and (self._options.sections == "fixed" or self.periodic):
            components += range(3, self.nodes.block)
        return (first_unknown[:, None] + np.array(components)).ravel()

    def _turn(self, constraints: Constraints, symmetry: Rotations, yarn: int) -> None:
        """Ties positions and directors of a yarn to those of the one that it is an image of."""
        angle = 2.0 * np.pi * symmetry.turns[yarn] / symmetry.fold
        unknowns = np.arange(*self.nodes.curves[[yarn, yarn + 1]]) * self.nodes.block
        to_leader = (
            self.nodes.curves[symmetry.leader[yarn]] - self.nodes.curves[yarn]
        ) * self.nodes.block
        for vector in range(0, self.nodes.block, 3):
            x = unknowns + vector
            across = np.column_stack([x, x + 1]) + to_leader
            constraints.combine_each(x, across, [np.cos(angle), -np.sin(angle)])
            constraints.combine_each(x + 1, across, [np.sin(angle), np.cos(angle)])
            constraints.tie(x + 2, x + 2 + to_leader)
            moved = np.concatenate([x, x + 1, x + 2])
            constraints.repeat(moved, moved + to_leader)
