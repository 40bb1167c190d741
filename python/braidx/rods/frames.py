"""Rigid bodies that nodes are part of.

A frame has twelve unknowns, its centre x and three directors g1, g2, g3. What is part of it is at
x + X1 g1 + X2 g2 + X3 g3, and its directors are D1 g1 + D2 g2 + D3 g3: linear in the unknowns however far it turns.
Lengths and angles of its directors are kept by the energy

    E = k / 4 |G^T G - G0^T G0|^2,  G = [g1 g2 g3]

(as for affine bodies: Lan et al., Affine body dynamics, 2022).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..system.terms import Floats, Ints, block_pattern
from .linked import Linked

SIZE = 12  # unknowns of a frame
RIGID = 1e3  # k over axial stiffness times size: forces that strain rods by 1 % strain a frame by 1e-5 at most


@dataclass(frozen=True)
class Frame:
    """One frame.

    Attributes:
        first: Its first unknown.
        stiffness: k, N mm.
        rest: Its unknowns when it was made, shape (12,).
    """

    first: int
    stiffness: float
    rest: Floats

    @property
    def unknowns(self) -> Ints:
        """Shape (1, 12)."""
        return np.arange(self.first, self.first + SIZE)[None, :]

    def vectors(self) -> Ints:
        """Unknowns of its centre and directors, shape (4, 3)."""
        return self.unknowns.reshape(4, 3)


def carried(first: int, rest: Floats, members: Sequence[Ints], q: Floats) -> Linked:
    """Nodes that are part of a frame.

    Args:
        first: First unknown of the frame.
        rest: Its unknowns now, shape (12,).
        members: Unknowns of the nodes, position first, then directors, shape (block,) each.
        q: All unknowns now.
    """
    centre, axes = rest[:3], rest[3:].reshape(3, 3)
    followers = np.concatenate(members).reshape(-1, 3)
    is_position = np.concatenate([np.arange(len(own) // 3) == 0 for own in members]).astype(float)
    place = np.linalg.solve(axes.T, (q[followers] - is_position[:, None] * centre).T).T
    leaders = np.broadcast_to(np.arange(first, first + SIZE).reshape(4, 3), (len(followers), 4, 3))
    factors = np.column_stack([is_position, place])
    return Linked.of(followers, leaders, factors)


class RigidTerm:
    """Keeps frames rigid."""

    pattern_version = 1
    spread = None

    def __init__(self, frames: Sequence[Frame], rank: int = 0) -> None:
        mine = list(frames) if rank == 0 else []
        unknowns = [frame.vectors()[1:] for frame in mine]
        self._unknowns: Ints = np.array(unknowns, dtype=np.int64).reshape(-1, 3, 3)
        self._stiffness = np.array([frame.stiffness for frame in mine])
        rest = np.array([frame.rest[3:] for frame in mine]).reshape(-1, 3, 3)
        self._metric = _metric(rest)
        self._directors: Floats = rest

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._directors = q[self._unknowns]

    def energy(self, own: Floats) -> float:
        """See Term."""
        return 0.25 * float(self._stiffness @ (self._excess() ** 2).sum(axis=(1, 2)))

    def add_residual(self, residual: Floats) -> None:
        """See Term."""
        forces = np.einsum("n,nab,nbi->nai", self._stiffness, self._excess(), self._directors)
        np.add.at(residual, self._unknowns, forces)

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        unknowns = self._unknowns.reshape(len(self._unknowns), 9)
        return block_pattern(unknowns, unknowns)

    def tangent_values(self) -> Floats:
        """See Term."""
        g, same = self._directors, np.eye(3)
        values = np.einsum("ac,nbi,nbj->naicj", same, g, g)
        values += np.einsum("nci,naj->naicj", g, g)
        values += np.einsum("nac,ij->naicj", self._excess(), same)
        return np.asarray(self._stiffness[:, None, None, None, None] * values).ravel()

    def _excess(self) -> Floats:
        return np.asarray(_metric(self._directors) - self._metric)


def _metric(directors: Floats) -> Floats:
    """Products of directors with each other, shape (n, 3, 3)."""
    return np.asarray(np.einsum("nai,nbi->nab", directors, directors))
