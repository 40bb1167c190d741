"""Couples on sections of beams, in directions that stay."""

from __future__ import annotations

import numpy as np

from ..system.terms import Floats, Ints, block_pattern


class CoupleTerm:
    """Couples M on nodes with two directors g1, g2: forces that do the work of M on the turn of the section.

    The turn of a section that deforms too is the one nearest to its change, w = J^-1 sum g_a x dg_a with
    J = sum (|g_a|^2 I - g_a g_a^T). So the forces are f_a = c x g_a, c = J^-1 M: they have the moment M and leave the
    lengths of the directors alone. Couples are not conservative: the tangent is not symmetric.

    Attributes:
        couples: N mm, shape (n, 3).
    """

    pattern_version = 1
    spread = None

    def __init__(self, directors: Ints, rank: int = 0) -> None:
        """Takes the unknowns of the directors of the nodes, shape (n, 6), and the number of the process."""
        self._unknowns = directors if rank == 0 else directors[:0]
        self.couples: Floats = np.zeros((len(directors), 3))
        self._directors: Floats = np.empty((0, 2, 3))

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._directors = q[self._unknowns].reshape(-1, 2, 3)

    def energy(self, own: Floats) -> float:
        """See Term: couples in directions that stay have no potential."""
        return float("nan") if self.couples.any() else 0.0

    def add_residual(self, residual: Floats) -> None:
        """See Term; the forces are given to one process only."""
        forces = np.cross(self._axis()[:, None], self._directors)
        np.subtract.at(residual, self._unknowns, forces.reshape(-1, 6))

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return block_pattern(self._unknowns, self._unknowns)

    def tangent_values(self) -> Floats:
        """See Term."""
        return -self._rates().ravel()

    def _axis(self) -> Floats:
        """c = J^-1 M, shape (n, 3)."""
        moments = self.couples[: len(self._directors)]
        return np.asarray(np.linalg.solve(self._inertia(), moments[:, :, None])[:, :, 0])

    def _inertia(self) -> Floats:
        g = self._directors
        square = np.einsum("nai,nai->n", g, g)
        return np.asarray(square[:, None, None] * np.eye(3) - np.einsum("nai,naj->nij", g, g))

    def _rates(self) -> Floats:
        """Derivatives of the forces by the directors, shape (n, 6, 6).

        With v = dg_b: dc = -J^-1 [2 (g_b . v) c - v (g_b . c) - g_b (v . c)], df_a = dc x g_a + c x dg_a.
        """
        g, c = self._directors, self._axis()
        inverse = np.linalg.inv(self._inertia())
        along = np.einsum("nbi,ni->nb", g, c)
        change = (
            2.0 * np.einsum("ni,nbj->nbij", c, g)
            - along[:, :, None, None] * np.eye(3)
            - np.einsum("nbi,nj->nbij", g, c)
        )
        axis_rate = -np.einsum("nik,nbkj->nbij", inverse, change)
        rates = np.zeros((len(g), 2, 3, 2, 3))
        for a in range(2):
            for b in range(2):
                # Columns of dc crossed with g_a.
                rates[:, a, :, b] = np.cross(
                    axis_rate[:, b], g[:, a, :, None], axisa=1, axisb=1, axisc=1
                )
            rates[:, a, :, a] += np.cross(c[:, :, None], np.eye(3)[None], axisa=1, axisb=1, axisc=1)
        return rates.reshape(-1, 6, 6)
