"""Loads and couples on rods, and their way from what they were to what is asked for.

Loads go there evenly, or at once: in full at every share of the way but its begin.
"""

from __future__ import annotations

import numpy as np

from ..system.terms import Floats, Ints
from .layout import Layout


class Ramp:
    """Vectors on their way, by some key."""

    def __init__(self) -> None:
        self._now: dict[int, Floats] = {}
        self._target: dict[int, Floats] = {}
        self._at_once: set[int] = set()

    def ask_for(self, key: int, value: Floats, at_once: bool = False) -> None:
        """A vector, shape (3,), from the next equilibria on."""
        self._now.setdefault(key, np.zeros(3))
        self._target[key] = value
        (self._at_once.add if at_once else self._at_once.discard)(key)

    @property
    def keys(self) -> Ints:
        """Shape (n,)."""
        return np.array(list(self._now), dtype=np.int64)

    def at(self, share: float) -> Floats:
        """Vectors at a share of the way, shape (n, 3)."""
        out = np.empty((len(self._now), 3))
        for row, (key, now) in enumerate(self._now.items()):
            done = 1.0 if share > 0.0 and key in self._at_once else share
            out[row] = now + done * (self._target[key] - now)
        return out

    def finish(self, share: float) -> None:
        """The way ends at this share of it; what was asked for stays asked for."""
        self._now = dict(zip(self._now, self.at(share), strict=True))


class Way:
    """Forces on all unknowns on their way, shape (num_unknowns,)."""

    def __init__(self, size: int) -> None:
        self.now: Floats = np.zeros(size)
        self._target: Floats = np.zeros(size)
        self._at_once: np.ndarray = np.zeros(size, dtype=bool)

    def grow(self, count: int) -> None:
        """Unknowns were added after all others."""
        none = np.zeros(count)
        self.now, self._target = np.append(self.now, none), np.append(self._target, none)
        self._at_once = np.append(self._at_once, none.astype(bool))

    def ask_for(self, unknowns: Ints, forces: Floats, at_once: bool = False) -> None:
        """Forces on unknowns, from the next equilibria on."""
        self._target[unknowns] = forces
        self._at_once[unknowns] = at_once

    def at(self, share: float) -> Floats:
        """Forces at a share of the way."""
        done = np.where(self._at_once & (share > 0.0), 1.0, share)
        return np.asarray(self.now + done * (self._target - self.now))

    def finish(self, share: float) -> None:
        """The way ends at this share of it; what was asked for stays asked for."""
        self.now = self.at(share)


class Loads:
    """Loads now and at the end of the next equilibria.

    Forces at nodes and loads along rods add up.

    Attributes:
        couples: By the first unknown of the directors that they act on.
        followers: Forces fixed to sections, by the first unknown of the node.
        pressures: By the number of the rod.
    """

    def __init__(self, layout: Layout) -> None:
        self._lengths = layout.lengths
        self._nodal, self._line, self._balance = (Way(layout.rest.size) for _ in range(3))
        self.couples, self.followers, self.pressures = Ramp(), Ramp(), Ramp()

    def grow(self, layout: Layout) -> None:
        """Unknowns were added after all others, without loads."""
        for way in (self._nodal, self._line, self._balance):
            way.grow(layout.rest.size - self._lengths.size)
        self._lengths = layout.lengths

    def force(self, unknowns: Ints, force: Floats, at_once: bool = False) -> None:
        """Force on each node, shape (3,), N."""
        self._nodal.ask_for(unknowns[:, :3], force, at_once)

    def line(self, unknowns: Ints, load: Floats, at_once: bool = False) -> None:
        """Load along a rod, shape (3,), N/mm."""
        positions = unknowns[:, :3]
        self._line.ask_for(positions, self._lengths[positions] * load, at_once)

    @property
    def has_followers(self) -> bool:
        """Whether there are loads without a potential."""
        return any(len(ramp.keys) for ramp in (self.couples, self.followers, self.pressures))

    def at(self, share: float) -> Floats:
        """Dead forces at a share of the way, shape (num_unknowns,)."""
        return self._nodal.at(share) + self._line.at(share) + self._balance.at(share)

    def balance(self, forces: Floats) -> None:
        """Adds forces, shape (num_unknowns,), N and N mm, to the loads now; the way takes them off."""
        self._balance.now = self._balance.now + forces

    def finish(self, share: float) -> None:
        """The way ends at this share of it; what was asked for stays asked for."""
        for way in (self._nodal, self._line, self._balance):
            way.finish(share)
        for ramp in (self.couples, self.followers, self.pressures):
            ramp.finish(share)
