"""One group of ends: where its conditions put it, how it may move from there, and what loads it (paper 1, 2.4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry import angles_of, best_fit, cross_matrix, rates_of, rotation_of
from ..scene import EndGroup
from ..system.constraints import Constraints, Floats, Ints
from ..system.equations import follow_best

SINGULAR = 1e-9  # inertia over the largest one below which there is no rotation


@dataclass(frozen=True)
class Pose:
    """Where a group is: the shift of its centroid (mm) and its rotation from the reference state.

    Attributes:
        shift: Displacement of the centroid, shape (3,), mm.
        angles: Tilts and turn (geometry/turns.py), shape (3,), radians.
    """

    shift: Floats
    angles: Floats


class Group:
    """Ends of some yarns, constrained and loaded together.

    Args:
        options: What the scene says.
        positions: Unknowns of the ends' positions, shape (m, 3).
        directors: Unknowns of directors that turn with the group, shape (d, 3); d may be 0.
        rest: All unknowns of the reference state.

    Attributes:
        unknowns: Unknowns of positions, then of directors, shape (3 (m + d),).
    """

    def __init__(self, options: EndGroup, positions: Ints, directors: Ints, rest: Floats) -> None:
        self.options, self._positions = options, positions
        vectors = np.vstack([positions, directors])
        self.unknowns: Ints = vectors.ravel()
        self._is_end = np.arange(len(vectors)) < len(positions)
        self._centre = rest[positions].mean(axis=0)
        self._arms = rest[vectors] - self._centre * self._is_end[:, None]
        self._constrained = np.array(options.constrained)
        self._motion, self._loads = np.array(options.motion), np.array(options.loads)

    def pose(self, q: Floats, axial: float, share: float) -> Pose:
        """Where the group belongs: as asked for where its motion is given, as in the state q where it is free.

        Args:
            q: All unknowns.
            axial: Displacement along the axis that the steps ask for, mm.
            share: How much is reached of what the scene asks for.
        """
        found = self.fit(q)
        free = np.concatenate([found.shift, found.angles])
        wanted = share * self._motion
        wanted[2] += axial
        both = np.where(self._constrained, wanted, free)
        return Pose(both[:3], both[3:])

    def fit(self, q: Floats) -> Pose:
        """Where the group is in a state, as well as a body can tell."""
        centre, vectors = self._vectors(q)
        return Pose(centre - self._centre, angles_of(best_fit(self._arms, vectors)))

    def place(self, q: Floats, pose: Pose) -> None:
        """Moves the ends in q to a pose: as one body, or with what they differ from one."""
        centre, vectors = self._vectors(q)
        if self.options.rigid:
            vectors = self._turned(pose)
        elif self._constrained[3:].any():
            turn = rotation_of(pose.angles) @ best_fit(self._arms, vectors).T
            vectors = vectors @ turn.T
        q[self.unknowns] = (vectors + (self._centre + pose.shift) * self._is_end[:, None]).ravel()

    def tie(self, constraints: Constraints, values: Floats, placed: Floats, pose: Pose) -> None:
        """A rigid group: all its unknowns follow a few of them.

        Args:
            constraints: Are added to.
            values: Their values, shape (num_unknowns,), filled in.
            placed: All unknowns with the group at its pose.
            pose: The pose.
        """
        modes = self._modes(self._turned(pose), rates_of(pose.angles))
        leading, follow = follow_best(modes[:, ~self._constrained])
        leaders = self.unknowns[leading]
        others = np.setdiff1d(np.arange(len(self.unknowns)), leading)
        followers, factors = self.unknowns[others], follow[others]
        spread = np.broadcast_to(leaders, (len(followers), len(leaders)))
        constraints.combine_each(followers, spread, factors)
        values[followers] = placed[followers] - factors @ placed[leaders]

    def means(self, pose: Pose) -> tuple[Floats, Floats]:
        """A group that is not rigid: equations of its means, rows @ q[unknowns] = values.

        The mean rotation is that of the best fit, which is exact: where R is it, the sum of (R arm) x position is 0.

        Returns:
            rows, shape (k, 3 m), and values, shape (k,).
        """
        modes = self._modes(self._turned(pose), rates_of(pose.angles))
        rows = (modes @ _inverse(modes.T @ modes)).T
        values = np.concatenate([self._centre + pose.shift, np.zeros(3)])
        return rows[self._constrained], values[self._constrained]

    def add_loads(self, loads: Floats, q: Floats, share: float) -> None:
        """Adds the group's force and moment, as dead loads in the state q, to the loads on all unknowns."""
        if self._loads.any():
            modes = self._modes(self._vectors(q)[1], np.eye(3))
            loads[self.unknowns] += modes @ _inverse(modes.T @ modes) @ (share * self._loads)

    def _vectors(self, q: Floats) -> tuple[Floats, Floats]:
        """Centroid, and arms and directors as they are, shape (m + d, 3)."""
        centre = q[self._positions].mean(axis=0)
        return centre, q[self.unknowns].reshape(-1, 3) - centre * self._is_end[:, None]

    def _turned(self, pose: Pose) -> Floats:
        """Arms and directors of the reference state, turned, shape (m + d, 3)."""
        turned: Floats = self._arms @ rotation_of(pose.angles).T
        return turned

    def _modes(self, arms: Floats, axes: Floats) -> Floats:
        """Motions of the unknowns along x, y, z, and about axes in columns, shape (3 (m + d), 6)."""
        shifts = self._is_end[:, None, None] * np.eye(3)
        turns = np.array([-cross_matrix(arm) @ axes for arm in arms])
        return np.concatenate([shifts, turns], axis=2).reshape(-1, 6)


def _inverse(inertia: Floats) -> Floats:
    """Inverse of number and inertia of ends; without those directions about which there is no rotation."""
    inverse = np.zeros((6, 6))
    for part in (slice(0, 3), slice(3, 6)):
        inverse[part, part] = np.linalg.pinv(inertia[part, part], rcond=SINGULAR, hermitian=True)
    return inverse
