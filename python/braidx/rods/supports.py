"""Supports of rods: unknowns that are held, means that are held, and how both are moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..system.constraints import ConstraintMap, Constraints
from ..system.terms import Floats, Ints
from .closed import Joints
from .linked import Linked
from .sections import SolidSections

Dependent = SolidSections | Joints | Linked  # what follows other unknowns, or has others follow it


@dataclass(frozen=True)
class Motion:
    """A rigid motion of held nodes: turned about a point, then moved.

    Attributes:
        unknowns: Of the nodes, position first, then directors, shape (n, block).
        turn: Rotation vector, radians.
        about: Centre of the turn, mm; None: each node about itself.
        by: Displacement, mm.
    """

    unknowns: Ints
    turn: Floats
    about: Floats | None
    by: Floats

    def apply(self, values: Floats, share: float) -> None:
        """Moves `values`, shape (num_unknowns,), by a share of the motion."""
        turn = Rotation.from_rotvec(share * self.turn)
        positions = values[self.unknowns[:, :3]]
        if self.about is not None:
            positions = self.about + turn.apply(positions - self.about)
        values[self.unknowns[:, :3]] = positions + share * self.by
        for first in range(3, self.unknowns.shape[1], 3):
            director = self.unknowns[:, first : first + 3]
            values[director] = turn.apply(values[director])


class Supports:
    """What is held, and where.

    Attributes:
        held: Values that held unknowns have now, shape (num_unknowns,).
        is_held: Which unknowns are held, shape (num_unknowns,).
        groups: Unknowns whose means are held, shape (n, num_components) each.
        means: Values that held means have now, mm, one array of shape (num_components,) per group.
    """

    def __init__(self, rest: Floats, dependents: Sequence[Dependent] = ()) -> None:
        self._dependents = list(dependents)
        self._following: ConstraintMap | None = None
        self.held = rest.copy()
        self.means: list[Floats] = []
        self.is_held: np.ndarray = np.zeros(rest.size, dtype=bool)
        self.groups: list[Ints] = []
        self._motions: list[Motion] = []
        self._shifts: list[tuple[int, Floats]] = []

    def grow(self, rest: Floats, dependents: Sequence[Dependent]) -> None:
        """Unknowns are added after all others, shape (n,), and what follows others.

        Raises:
            ValueError: If unknowns would follow each other in a circle.
        """
        before, held = self._dependents, self.held
        self.held = np.append(held, rest)
        self._dependents, self._following = [*before, *dependents], None
        try:
            self._resolved
        except ValueError:
            self.held, self._dependents, self._following = held, before, None
            raise
        self.is_held = np.append(self.is_held, np.zeros(rest.size, dtype=bool))

    def follows(self, unknowns: Ints) -> np.ndarray:
        """Whether unknowns follow others, shape as theirs."""
        return np.isin(unknowns, self._resolved.free, invert=True)

    def has_mean_of(self, unknowns: Ints) -> bool:
        """Whether one of them is in a mean that is held."""
        return any(np.isin(unknowns, group).any() for group in self.groups)

    def fold(self, forces: Floats) -> Floats:
        """Forces as they act on what follows nothing, shape (num_unknowns,)."""
        out = np.zeros_like(forces)
        out[self._resolved.free] = self._resolved.reduce(forces)
        return out

    def hold(self, unknowns: Ints, q: Floats) -> None:
        """Unknowns stay where they are in the state q."""
        fresh = np.unique(unknowns)[~self.is_held[np.unique(unknowns)]]
        self.held[fresh] = q[fresh]
        self.is_held[fresh] = True

    def release(self, unknowns: Ints) -> None:
        """Unknowns are free again."""
        self.is_held[unknowns] = False

    def hold_mean(self, positions: Ints, q: Floats) -> int:
        """The mean of unknowns of nodes, shape (n, num_components), stays where it is; number of the group."""
        self.groups.append(positions)
        self.means.append(q[positions].mean(axis=0))
        return len(self.groups) - 1

    def move(self, motion: Motion) -> None:
        """Nodes take part in a motion while the next equilibria are found.

        Raises:
            ValueError: If one of their unknowns is not held and the motion would be lost on it.
        """
        moved = motion.unknowns[:, :3] if not motion.turn.any() else motion.unknowns
        loose = ~self.is_held[moved]
        needed = np.broadcast_to(motion.by != 0.0, (len(moved), 3))
        if motion.turn.any():
            needed = np.ones(moved.shape, dtype=bool)
            if motion.about is None:
                needed[:, :3] = motion.by != 0.0
        if np.any(loose & needed):
            raise ValueError(
                "a node that is moved or turned is free to go elsewhere: clamp it, or hold the components that move"
            )
        self._motions.append(motion)

    def shift_mean(self, group: int, by: Floats) -> None:
        """The mean position of a group moves while the next equilibria are found, mm."""
        self._shifts.append((group, by))

    def advanced(self, share: float) -> tuple[Floats, list[Floats]]:
        """Held values and means after a share of the motions that are left."""
        held, means = self.held.copy(), [mean.copy() for mean in self.means]
        for motion in self._motions:
            motion.apply(held, share)
        for group, by in self._shifts:
            means[group] += share * by
        return held, means

    def finish(self, share: float) -> None:
        """Motions end at this share of them; what is left is not done."""
        self.held, self.means = self.advanced(share)
        self._motions.clear()
        self._shifts.clear()

    def constraints(self) -> ConstraintMap:
        """What the supports leave free."""
        constraints = self._followers()
        constraints.hold(np.flatnonzero(self.is_held))
        for group in self.groups:
            for component in group.T:
                constraints.hold_mean(component)
        return constraints.resolve()

    @property
    def _resolved(self) -> ConstraintMap:
        """What follows others, whatever is held."""
        if self._following is None:
            self._following = self._followers().resolve()
        return self._following

    def _followers(self) -> Constraints:
        constraints = Constraints(self.held.size)
        for dependent in self._dependents:
            dependent.constrain(constraints)
        return constraints

    def values(self, held: Floats, means: list[Floats]) -> Floats:
        """Inhomogeneous values of the constraints, shape (num_unknowns,)."""
        values = np.where(self.is_held, held, 0.0)
        for group, mean in zip(self.groups, means, strict=True):
            values[group[-1]] = len(group) * mean
        return values
