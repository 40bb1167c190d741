"""Dead loads and couples on rods, and their way from what they were to what is asked for."""

from __future__ import annotations

import numpy as np

from ..system.terms import Floats, Ints
from .layout import Layout


class Loads:
    """Loads now and at the end of the next equilibria.

    Forces at nodes and loads along rods add up. Couples are kept per node, by the first unknown of its directors.
    """

    def __init__(self, layout: Layout) -> None:
        self._lengths = layout.lengths
        self._now: Floats = np.zeros(layout.rest.size)
        self._nodal: Floats = np.zeros(layout.rest.size)
        self._line: Floats = np.zeros(layout.rest.size)
        self._couples: dict[int, tuple[Floats, Floats]] = {}

    def grow(self, layout: Layout) -> None:
        """Unknowns were added after all others, without loads."""
        none = np.zeros(layout.rest.size - self._now.size)
        self._lengths = layout.lengths
        self._now, self._nodal, self._line = (
            np.append(part, none) for part in (self._now, self._nodal, self._line)
        )

    def force(self, unknowns: Ints, force: Floats) -> None:
        """Force on each node, shape (3,), N."""
        self._nodal[unknowns[:, :3]] = force

    def line(self, unknowns: Ints, load: Floats) -> None:
        """Load along a rod, shape (3,), N/mm."""
        positions = unknowns[:, :3]
        self._line[positions] = self._lengths[positions] * load

    def couple(self, unknowns: Ints, couple: Floats, rod: int) -> None:
        """Couple on one node, shape (3,), N mm.

        Raises:
            ValueError: If the node has no directors.
        """
        if unknowns.shape[1] < 9:
            raise ValueError(
                f"rod {rod} is a cable: couples act on sections, give a Beam or a Solid"
            )
        first = int(unknowns[0, 3])
        before = self._couples.get(first, (np.zeros(3), np.zeros(3)))[0]
        self._couples[first] = (before, couple)

    @property
    def has_couples(self) -> bool:
        return bool(self._couples)

    def directors(self) -> Ints:
        """Unknowns of the directors that couples act on, shape (n, 6)."""
        first = np.array(list(self._couples), dtype=np.int64)
        return first[:, None] + np.arange(6)

    def at(self, share: float) -> tuple[Floats, Floats]:
        """Forces, shape (num_unknowns,), and couples, shape (n, 3), at a share of the way."""
        target = self._nodal + self._line
        couples = [begin + share * (end - begin) for begin, end in self._couples.values()]
        return self._now + share * (target - self._now), np.array(couples).reshape(-1, 3)

    def balance(self, forces: Floats) -> None:
        """Adds forces, shape (num_unknowns,), N and N mm, to the loads now; the way takes them off."""
        self._now = self._now + forces

    def finish(self, share: float) -> None:
        """The way ends at this share of it; what was asked for stays asked for."""
        now, couples = self.at(share)
        self._now = now
        for row, (key, (_, end)) in enumerate(list(self._couples.items())):
            self._couples[key] = (couples[row], end)
