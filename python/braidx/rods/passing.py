"""Increments in which rods would go through each other unseen: contact knows only what is near at their ends."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from ..contact.contact import Contact
from ..solver.trial import Diverged
from ..system.terms import Floats, Ints
from .layout import Layout

NEAR = 0.5  # sums of radii: centre lines that come nearer on the way have passed
PACE = 0.5  # thinnest radii that nodes move between two looks
MOST = 100  # looks at an increment


def refuse_passing(layout: Layout, contact: Contact, before: Floats, after: Floats) -> None:
    """Looks at states on the straight way between two; increments too short for a passage are not looked at.

    Args:
        before, after: Unknowns, shape (num_unknowns,).
    Raises:
        Diverged: If centre lines meet on the way.
    """
    chords = Chords.of(layout, contact)
    moved = float(np.linalg.norm((after - before)[chords.positions], axis=1).max())
    looks = min(MOST, int(moved / (PACE * contact.min_radius)))
    if looks < 2:
        return
    # What overlaps to begin with, as the ends of a ring do, says nothing of the way.
    known = chords.meetings(before)
    for share in np.arange(1, looks) / looks:
        met = chords.meetings((1.0 - share) * before + share * after) - known
        if met:
            raise Diverged("rod {} would go through rod {} on the way".format(*min(met)), 0, 0)


@dataclass(frozen=True)
class Chords:
    """Straight pieces between neighbouring nodes of all rods.

    Attributes:
        positions: Unknowns of the positions of all nodes, rod by rod, shape (num_nodes, 3).
        first: Node that each chord starts at, the next one being its end, shape (num_chords,).
        rod: Of each chord, shape (num_chords,).
        radius: Of each chord's rod, mm, shape (num_chords,).
        self_exclusion: Radii along a rod within which it does not meet itself.
        others: Whether a rod may meet others.
    """

    positions: Ints
    first: Ints
    rod: Ints
    radius: Floats
    self_exclusion: float
    others: bool

    @classmethod
    def of(cls, layout: Layout, contact: Contact) -> Chords:
        rods = range(len(layout.first))
        positions = np.concatenate([layout.unknowns(rod, slice(None))[:, :3] for rod in rods])
        owner = np.repeat(rods, layout.num_nodes)
        first = np.flatnonzero(owner[1:] == owner[:-1])
        rod = owner[first]
        exclusion = float(contact.pairing.search.self_exclusion)
        others = contact.layout.group is None
        return cls(positions, first, rod, layout.radius[rod], exclusion, others)

    def meetings(self, state: Floats) -> set[tuple[int, int]]:
        """Pairs of rods, the lower number first, that have chords too near each other in a state."""
        nodes = state[self.positions]
        begin, end = nodes[self.first], nodes[self.first + 1]
        length = np.linalg.norm(end - begin, axis=1)
        middle = (begin + end) / 2.0
        farthest = 2.0 * NEAR * self.radius.max() + length.max()
        i, j = cKDTree(middle).query_pairs(farthest, output_type="ndarray").T
        limit = NEAR * (self.radius[i] + self.radius[j])
        reach = limit + (length[i] + length[j]) / 2.0
        asked = self._may_meet(i, j, length)
        asked &= np.linalg.norm(middle[i] - middle[j], axis=1) <= reach
        i, j = i[asked], j[asked]
        near = _distances(nodes, nodes, self.first[i], self.first[j]) < limit[asked]
        return set(zip(self.rod[i[near]].tolist(), self.rod[j[near]].tolist(), strict=True))

    def _may_meet(self, i: Ints, j: Ints, length: Floats) -> npt.NDArray[np.bool_]:
        """Whether chords i and j are of rods that may meet, or far from each other on one that may meet itself."""
        before = np.cumsum(length) - length
        apart = np.abs(before[i] - before[j]) > self.self_exclusion * self.radius[i]
        return np.where(self.rod[i] == self.rod[j], apart, self.others)


def _distances(a: Floats, b: Floats, i: Ints, j: Ints) -> Floats:
    """Of chords i of a line from chords j of another, shape (n,), mm."""
    u, v, w = a[i + 1] - a[i], b[j + 1] - b[j], a[i] - b[j]
    uu, vv, uv = (u * u).sum(-1), (v * v).sum(-1), (u * v).sum(-1)
    uw, vw = (u * w).sum(-1), (v * w).sum(-1)
    det = np.maximum(uu * vv - uv**2, 1e-12 * uu * vv)
    s = np.clip((uv * vw - vv * uw) / det, 0.0, 1.0)
    t = np.clip((uv * s + vw) / vv, 0.0, 1.0)
    s = np.clip((uv * t - uw) / uu, 0.0, 1.0)
    return np.asarray(np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=-1))
