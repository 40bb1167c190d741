"""The clamps at both ends of a bent rope: rigid plane sections that yarns and core end in.

A clamp has nine unknowns, the position x of the rope's axis and two directors g1, g2, like the section of a beam
(paper 1, eq. 1): what ends in it is at x + xi1 g1 + xi2 g2, which is linear in the unknowns however far the rope turns.
The rope bends in the plane of y and z: g1 stays along x, g2 turns in that plane, and all that is left to be seen to is
that it keeps its length:

    E = k / 4 (g2 . g2 - 1)^2
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...system.constraints import Constraints, Floats, Ints
from ...system.terms import block_pattern

SIZE = 9  # unknowns of a clamp


@dataclass(frozen=True)
class Clamp:
    """One clamp.

    Attributes:
        first_unknown: Number of its first unknown.
        height: Where it is along the axis of the straight rope, mm.
    """

    first_unknown: int
    height: float

    def vector(self, which: int) -> Ints:
        """Unknowns of x (0), g1 (1) or g2 (2), shape (3,)."""
        return self.first_unknown + 3 * which + np.arange(3)

    @property
    def axial(self) -> int:
        """Unknown of its position along the axis of the straight rope."""
        return self.first_unknown + 2

    @property
    def travel(self) -> int:
        """Unknown of its position towards the sheave, which lies at negative values."""
        return self.first_unknown + 1

    @property
    def start(self) -> Floats:
        """Its unknowns in the straight rope, shape (9,)."""
        return np.array([0.0, 0.0, self.height, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0])

    def slope(self, q: Floats) -> float:
        """Angle that it has turned by, radians, positive where the rope rises along its axis."""
        y, z = q[self.vector(2)[1:]]
        return math.atan2(-z, y)

    def hold(self, constraints: Constraints, values: Floats) -> None:
        """Keeps it in the plane of bending, with its position towards the sheave prescribed."""
        held = np.concatenate([self.vector(0)[:2], self.vector(1), self.vector(2)[:1]])
        constraints.hold(held)
        values[held] = self.start[held - self.first_unknown]

    def carry(self, constraints: Constraints, positions: Ints, start: Floats) -> None:
        """Particles that are part of it.

        What is off its plane, as the ends of solid yarns are that run aslant, is so along g3 = g1 x g2. Since g1 stays
        along x, that is (0, -g2z, g2y): linear, too.

        Args:
            constraints: Are added to.
            positions: First unknowns of the particles' positions, shape (n,).
            start: All unknowns of the straight rope.
        """
        component = np.arange(3)
        unknowns = positions[:, None] + component
        place = start[unknowns] - np.array([0.0, 0.0, self.height])
        x, g1, g2 = (self.vector(which) for which in range(3))
        leaders = np.stack([x, g1, g2, g2[[0, 2, 1]]], axis=1)  # (3, 4)
        factors = np.empty((len(positions), 3, 4))
        factors[:, :, 0] = 1.0
        factors[:, :, 1:3] = place[:, None, :2]
        factors[:, :, 3] = place[:, 2:] * np.array([0.0, -1.0, 1.0])
        of = np.broadcast_to(leaders, factors.shape)
        constraints.combine_each(unknowns.ravel(), of.reshape(-1, 4), factors.reshape(-1, 4))


class ClampTerm:
    """Term of the global system that keeps turning directors at length one.

    Args:
        directors: Unknowns of those of clamps and of a sheave that turns freely, shape (n, 3).
        stiffness: k, N mm.
        mine: Whether this process gives forces and stiffness.
    """

    pattern_version = 1
    spread = None

    def __init__(self, directors: Sequence[Ints], stiffness: float, mine: bool = True) -> None:
        self._unknowns = np.array(directors if mine else [], dtype=np.int64).reshape(-1, 3)
        self._stiffness = stiffness
        self._director: Floats = np.zeros(self._unknowns.shape)

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._director = q[self._unknowns]

    def energy(self, own: Floats | None = None) -> float:
        """See Term, mJ; clamps are nobody's images."""
        return 0.25 * self._stiffness * float((self._excess() ** 2).sum())

    def add_residual(self, residual: Floats) -> None:
        """See Term."""
        residual[self._unknowns] += self._stiffness * self._excess()[:, None] * self._director

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return block_pattern(self._unknowns, self._unknowns)

    def tangent_values(self) -> Floats:
        """See Term."""
        g = self._director
        values = 2.0 * np.einsum("ni,nj->nij", g, g) + self._excess()[:, None, None] * np.eye(3)
        return np.asarray(self._stiffness * values).ravel()

    def _excess(self) -> Floats:
        """g2 . g2 - 1 of each clamp."""
        return np.asarray((self._director**2).sum(axis=1) - 1.0)
