"""Shear of a beam's sections at its nodes, against the tangents there.

Shear that is integrated at one Gauss point per element of degree 1 does not see sections that tilt to and fro from
node to node: only bending resists, which is as good as nothing in a bundle of filaments, and friction at the surface
turns them as far as it likes. The tangent of a node is the central difference of its neighbours' positions: unlike
the elements' own it is exact where a yarn is bent evenly, so that nothing locks. A share of the shear energy taken
here suffices (`SHARE`); the elements have the rest.

    E = 1/2 sum_i c_i sum_a (g_a . d - G_a . D)^2,    d = (x_(i+1) - x_(i-1)) / (rest length between them)
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ..system.terms import block_pattern
from .layout import CurveLayout, FloatArray, IntArray

SHARE = 0.1  # of the shear stiffness


class SectionTilt:
    """Term of the global system; forces and stiffness are given by one process only.

    Args:
        layout: Curves of degree 1.
        rest: Reference state, shape (num_nodes, 9).
        shear_stiffness: G A of each yarn's share, N; one value, or one per node.
        mine: Whether this process gives them.
        first_unknown: Number of the first unknown of the first node.
    """

    pattern_version = 1
    spread = None

    def __init__(
        self,
        layout: CurveLayout,
        rest: FloatArray,
        shear_stiffness: float | FloatArray,
        mine: bool = True,
        first_unknown: int = 0,
    ) -> None:
        ends = np.concatenate([layout.curves[:-1], layout.curves[1:] - 1])
        node = np.setdiff1d(np.arange(layout.num_nodes), ends) if mine else np.empty(0, np.int64)
        self._node, self._first_unknown = node, first_unknown
        self._shear_stiffness = np.broadcast_to(shear_stiffness, layout.num_nodes)[node]
        vectors = [9 * node + 3, 9 * node + 6, 9 * (node - 1), 9 * (node + 1)]
        unknowns = (np.stack(vectors, axis=1)[:, :, None] + np.arange(3)).reshape(-1, 12)
        self._unknowns = unknowns + first_unknown
        self.set_reference(rest)

    def set_reference(self, rest: FloatArray) -> None:
        """Makes a state, shape (num_nodes, 9), the one that is free of shear."""
        node = self._node
        before, after = rest[node - 1, :3], rest[node + 1, :3]
        span = np.linalg.norm(after - rest[node, :3], axis=1)
        span += np.linalg.norm(rest[node, :3] - before, axis=1)
        self._slope = 1.0 / span
        self._stiffness = self._shear_stiffness * span / 2.0
        self._rest: FloatArray = np.zeros((len(node), 2))
        self._take(rest.ravel()[self._unknowns - self._first_unknown])
        self._rest = self._tilt()

    def set_state(self, q: FloatArray) -> None:
        """See Term."""
        self._take(q[self._unknowns])

    def _take(self, unknowns: FloatArray) -> None:
        vectors = unknowns.reshape(-1, 4, 3)
        self._directors = vectors[:, :2]
        self._tangent = (vectors[:, 3] - vectors[:, 2]) * self._slope[:, None]

    def energy(self, own: FloatArray | None = None) -> float:
        """See Term; of all nodes by default, mJ."""
        stiffness = self._stiffness if own is None else self._stiffness * own[self._unknowns[:, 0]]
        return 0.5 * float(stiffness @ (self._tilt() ** 2).sum(axis=1))

    def add_residual(self, residual: FloatArray) -> None:
        """See Term."""
        forces = self._stiffness[:, None] * np.einsum("na,nai->ni", self._tilt(), self._gradients())
        np.add.at(residual, self._unknowns, forces)

    def tangent_pattern(self) -> tuple[IntArray, IntArray]:
        """See Term."""
        return block_pattern(self._unknowns, self._unknowns)

    def tangent_values(self) -> npt.NDArray[np.float64]:
        """See Term."""
        gradients = self._gradients()
        values = np.einsum("nai,naj->nij", gradients, gradients)
        twist = self._tilt() * self._slope[:, None]
        component = np.arange(3)
        for a in range(2):
            director = 3 * a + component
            for sign, position in ((-1.0, 6 + component), (1.0, 9 + component)):
                values[:, director, position] += sign * twist[:, a, None]
                values[:, position, director] += sign * twist[:, a, None]
        return np.asarray(self._stiffness[:, None, None] * values).ravel()

    def _tilt(self) -> FloatArray:
        """Shear of both directors beyond that of the reference state, shape (n, 2)."""
        return np.einsum("nai,ni->na", self._directors, self._tangent) - self._rest

    def _gradients(self) -> FloatArray:
        """Of the shears with g1, g2, the position before and the one after, shape (n, 2, 12)."""
        out = np.zeros((len(self._unknowns), 2, 12))
        moved = self._directors * self._slope[:, None, None]
        for a in range(2):
            out[:, a, 3 * a : 3 * a + 3] = self._tangent
        out[:, :, 6:9], out[:, :, 9:] = -moved, moved
        return out
