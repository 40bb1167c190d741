"""Loads that turn with rods: forces fixed to sections, and pressure along rods. Neither is conservative."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..system.terms import Floats, Ints, block_pattern

# Integrals of N_i dN_j over an element, by its degree.
SHAPES = {
    1: np.array([[-1, 1], [-1, 1]]) / 2.0,
    2: np.array([[-3, 4, -1], [-4, 0, 4], [1, -4, 3]]) / 6.0,
}


class FollowerForceTerm:
    """Forces on nodes with directors: |a| along a1 g1 + a2 g2 + a3 g1 x g2.

    Attributes:
        forces: Components a along g1, g2 and the section's normal, N, shape (n, 3).
    """

    pattern_version = 1
    spread = None

    def __init__(self, unknowns: Ints, rank: int = 0) -> None:
        """Takes the unknowns of the nodes, shape (n, 9), and the number of the process."""
        self._unknowns = unknowns if rank == 0 else unknowns[:0]
        self.forces: Floats = np.zeros((len(unknowns), 3))
        self._directors: Floats = np.zeros((len(self._unknowns), 2, 3))

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._directors = q[self._unknowns[:, 3:]].reshape(-1, 2, 3)

    def energy(self, own: Floats) -> float:
        """See Term: forces that follow have no potential."""
        return float("nan") if self.forces.any() else 0.0

    def add_residual(self, residual: Floats) -> None:
        """See Term; the forces are given to one process only."""
        way, size, load = self._ways()
        forces = load[:, None] * way / size[:, None]
        np.subtract.at(residual, self._unknowns[:, :3], forces)

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return block_pattern(self._unknowns[:, :3], self._unknowns[:, 3:])

    def tangent_values(self) -> Floats:
        """See Term: the change of way / |way| by the directors."""
        (way, size, load), a = self._ways(), self._components()
        g1, g2 = self._directors[:, 0], self._directors[:, 1]
        by_1 = a[:, 0, None, None] * np.eye(3) - a[:, 2, None, None] * _cross(g2)
        by_2 = a[:, 1, None, None] * np.eye(3) + a[:, 2, None, None] * _cross(g1)
        unit = way / size[:, None]
        across = np.eye(3) - unit[:, :, None] * unit[:, None, :]
        change = across @ np.concatenate([by_1, by_2], axis=2)
        return np.asarray(-(load / size)[:, None, None] * change).ravel()

    def _components(self) -> Floats:
        return self.forces[: len(self._unknowns)]

    def _ways(self) -> tuple[Floats, Floats, Floats]:
        """Way of each force, its length, at least so that nothing is divided by 0, and the force's size, N."""
        a, (g1, g2) = self._components(), self._directors.transpose(1, 0, 2)
        way = a[:, :1] * g1 + a[:, 1:2] * g2 + a[:, 2:] * np.cross(g1, g2)
        load = np.linalg.norm(a, axis=1)
        size = np.linalg.norm(way, axis=1)
        return np.asarray(way), np.where(load > 0.0, size, 1.0), load


class PressureTerm:
    """Loads per present length of rods, to one side of them: p e x t, with the unit tangent t.

    Integrated, a load on node i is the sum of p C_ij e x x_j over the nodes j of its elements: linear in the unknowns.

    Attributes:
        pressures: p e of each rod, N/mm, shape (num_rods, 3).
    """

    pattern_version = 1
    spread = None

    def __init__(self, lines: Sequence[Ints], degrees: Sequence[int], rank: int = 0) -> None:
        """Takes the unknowns of positions of each rod, shape (num_nodes, 3), its degree, and the process."""
        self.pressures: Floats = np.zeros((len(lines), 3))
        rows: list[Ints] = [np.empty((0, 3), dtype=np.int64)]
        cols: list[Ints] = [np.empty((0, 3), dtype=np.int64)]
        factors: list[Floats] = [np.empty(0)]
        rods: list[Ints] = [np.empty(0, dtype=np.int64)]
        for rod, (line, degree) in enumerate(zip(lines, degrees, strict=True)):
            nodes = np.arange(0, len(line) - 1, degree)[:, None] + np.arange(degree + 1)
            elements = line[nodes if rank == 0 else nodes[:0]]
            i, j = np.indices((degree + 1, degree + 1)).reshape(2, -1)
            rows.append(elements[:, i].reshape(-1, 3))
            cols.append(elements[:, j].reshape(-1, 3))
            factors.append(np.tile(SHAPES[degree].ravel(), len(elements)))
            rods.append(np.full(len(rows[-1]), rod))
        self._rows, self._cols = np.concatenate(rows), np.concatenate(cols)
        self._factors, self._rods = np.concatenate(factors), np.concatenate(rods)
        self._q: Floats = np.empty(0)

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._q = q

    def energy(self, own: Floats) -> float:
        """See Term: pressure has none where ends of rods may move."""
        return float("nan") if self.pressures.any() else 0.0

    def add_residual(self, residual: Floats) -> None:
        """See Term."""
        forces = self._factors[:, None] * np.cross(self.pressures[self._rods], self._q[self._cols])
        np.subtract.at(residual, self._rows, forces)

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return block_pattern(self._rows, self._cols)

    def tangent_values(self) -> Floats:
        """See Term."""
        turned = _cross(self.pressures[self._rods])
        return np.asarray(-self._factors[:, None, None] * turned).ravel()


def _cross(vectors: Floats) -> Floats:
    """Matrices that take cross products with vectors from the left, shape (n, 3, 3)."""
    return np.stack([np.cross(vectors, axis) for axis in np.eye(3)], axis=2)
