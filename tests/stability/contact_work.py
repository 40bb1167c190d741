"""Work that contacts take from yarns on their way from one state to the next, by their forces in both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from braidx.output.contact_table import ContactTable
from lines import FINER, smooth

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Moved:
    """Yarns and what presses them on each other in one of two states, and how they move from the one to the other.

    Attributes:
        table: Contacts of the state.
        places, motions: Unknowns of the state, and by how much they grow, shape (num_yarns, num_nodes, 3 or 9), mm.
        goes_on: Whether the rope repeats itself past its ends.
        radius: Of yarns, mm.
    """

    table: ContactTable
    places: Floats
    motions: Floats
    goes_on: bool
    radius: float

    def work(self) -> Floats:
        """What pressing forces take on the way, and what friction does, if they stay as they are; shape (2,), mJ."""
        table = self.table
        (near, far), (near_rub, far_rub) = zip(
            self._of_side(table.yarn_a, -1.0), self._of_side(table.yarn_b, 1.0), strict=True
        )
        rub = float((table.friction_force * (far_rub - near_rub)).sum())
        return -np.array([float(table.normal_force @ (far - near)), rub])

    def _of_side(self, yarns: npt.NDArray[np.int64], side: float) -> tuple[Floats, Floats]:
        """Motion of surfaces along normals, shape (m,), and of particles, shape (m, 3), mm; of a core, which is rigid,
        none.
        """
        table = self.table
        along, particles = np.zeros(len(yarns)), np.zeros((len(yarns), 3))
        for yarn in np.unique(yarns[yarns >= 0]):
            rows = np.flatnonzero(yarns == yarn)
            # Places of contacts are midway between centre lines, and on the surface of a core.
            halves = np.where(table.yarn_b[rows] < 0, 0.0, table.gap[rows] / 2.0) + self.radius
            centre = table.position[rows] + side * halves[:, None] * table.normal[rows]
            at, moved, where = self._nearest(int(yarn), centre)
            along[rows] = (moved[:, :3] * table.normal[rows]).sum(axis=1)
            particles[rows] = moved[:, :3]
            if at.shape[1] == 9:
                wider = self._widening(int(yarn), where, table.normal[rows])
                along[rows] -= side * self.radius * wider
                particles[rows] = at_arms(at, moved, table.position[rows])
        return along, particles

    def _widening(self, yarn: int, where: Floats, normals: Floats) -> Floats:
        """By how much half widths along normals, shape (m, 3), grow over the radius: at nodes, linear in between."""
        num_elements = self.places.shape[1] - 1
        element = np.floor(np.clip(where % num_elements, 0.0, num_elements - 1e-9)).astype(int)
        share = where % num_elements - element
        ends = [
            widening(self.places[yarn, node], self.motions[yarn, node], normals)
            for node in (element, element + 1)
        ]
        return np.asarray((1.0 - share) * ends[0] + share * ends[1])

    def _nearest(self, yarn: int, places: Floats) -> tuple[Floats, Floats, Floats]:
        """Where the line of a yarn is nearest to places: its unknowns, by how much they grow, and where that is.

        Returns:
            Shapes (m, 3 or 9), mm, and (m,), in elements.
        """
        place, motion = (
            smooth_all(values[yarn], self.goes_on) for values in (self.places, self.motions)
        )
        period, further = (
            values[-1, :3] - values[0, :3] if self.goes_on else np.zeros(3)
            for values in (place, motion)
        )
        copies = np.arange(-1, 2) if self.goes_on else np.zeros(1, dtype=int)
        points = np.concatenate([place[:-1] + copy * _padded(period, place) for copy in copies])
        moves = np.concatenate([motion[:-1] + copy * _padded(further, place) for copy in copies])
        nearest = np.clip(cKDTree(points[:, :3]).query(places)[1], 1, len(points) - 2)
        along = (points[nearest + 1] - points[nearest - 1]) / 2.0
        away, tangent = places - points[nearest, :3], along[:, :3]
        ahead = (away * tangent).sum(axis=1) / (tangent**2).sum(axis=1)
        rate = (moves[nearest + 1] - moves[nearest - 1]) / 2.0
        at, moved = (
            values[nearest] + ahead[:, None] * change
            for values, change in ((points, along), (moves, rate))
        )
        return at, moved, (nearest + ahead) / FINER


def widening(at: Floats, moved: Floats, normal: Floats) -> Floats:
    """By how much half widths across a normal grow over the radius (docs/theory.md); shapes (m, 9), (m, 9), (m, 3)."""

    def half_width(unknowns: Floats) -> Floats:
        g = unknowns[:, 3:].reshape(-1, 2, 3)
        c = np.einsum("mki,mi->mk", g, normal)
        facing = np.einsum("mk,mki->mi", c, g)
        return np.asarray(np.linalg.norm(facing, axis=1) / np.linalg.norm(c, axis=1))

    step = 1e-4
    return (half_width(at + step * moved) - half_width(at - step * moved)) / (2.0 * step)


def at_arms(at: Floats, moved: Floats, places: Floats) -> Floats:
    """Motion of the particles of beams at places; shapes (m, 9), (m, 9), (m, 3), mm."""
    g, turned = (values[:, 3:].reshape(-1, 2, 3) for values in (at, moved))
    arm = places - at[:, :3]
    within = np.linalg.solve(g @ g.swapaxes(1, 2), g @ arm[:, :, None])[:, :, 0]
    return np.asarray(moved[:, :3] + np.einsum("mk,mki->mi", within, turned))


def _padded(period: Floats, values: Floats) -> Floats:
    return np.append(period, np.zeros(values.shape[1] - 3))


def smooth_all(values: Floats, goes_on: bool) -> Floats:
    """Positions along the smooth line through nodes, with directors between these; shape (n, 3 or 9), mm."""
    line = smooth(values[:, :3], goes_on)
    nodes = np.arange(len(values))
    fine = np.arange(len(line)) / FINER
    directors = [np.interp(fine, nodes, column) for column in values[:, 3:].T]
    return np.column_stack([line, *directors])


def contact_work(
    states: Sequence[tuple[ContactTable, Floats]], moved: Floats, goes_on: bool, radius: float
) -> Floats:
    """Work that contacts take on a way if forces are those at its begin, and if they are those at its end, mJ.

    Args:
        states: Contacts and unknowns at begin and end.
        moved: By how much unknowns grow, shape (num_yarns, num_nodes, 3 or 9), mm.
        goes_on, radius: As for Moved.
    Returns:
        Shape (2, 2): state; pressing and friction.
    """
    return np.array([Moved(table, q, moved, goes_on, radius).work() for table, q in states])
