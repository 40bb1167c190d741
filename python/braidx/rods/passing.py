"""Increments in which rods would go through each other unseen: contact knows only what is near at their ends."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp
from scipy.spatial import cKDTree

from ..contact.contact import Contact
from ..solver.trial import Diverged
from ..system.terms import Floats, Ints
from .chords import chord_distances
from .contact import may_touch
from .layout import Layout
from .true_curve import curve_points

NEAR = 0.5  # sums of radii: centre lines that come nearer have passed, or are about to
PACE = 0.5  # thinnest radii that nodes move between two looks: a passage is as long as two radii at least


def refuse_passing(
    layout: Layout, contact: Contact, before: Floats, after: Floats, leap: bool = False
) -> None:
    """Looks at the state reached and at those on the straight way to it.

    The way is bisected. A part of it on which no two rods can meet, as far from each other as they are in its middle
    and as far as they move, is not looked at any closer: the number of looks has no limit, and long ways of rods that
    move together need few.

    Args:
        before, after: Unknowns, shape (num_unknowns,).
        leap: Whether rods may get there by any way; only the state reached counts then.
    Raises:
        Diverged: If centre lines meet.
    """
    chords = Chords.of(layout, contact, before, after)
    met = chords.meetings(after)
    if met:
        raise Diverged("rods {} and {} are deep in each other".format(*min(met)), 0, 0)
    motion = chords.points(after - before)
    motion -= motion.mean(axis=0)
    moved = np.linalg.norm(motion, axis=1)
    looks = int(moved.max() / (PACE * contact.min_radius))
    if leap or looks < 2:
        return
    # Parts to begin with are so short that the search stays local: within them nodes move by the longest chord.
    count = max(1, int(moved.max() / chords.longest(before)))
    ends = np.unique(np.linspace(0, looks, count + 1).astype(int))
    parts = list(zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True))
    while parts:
        first, last = parts.pop()
        middle = (first + last) // 2
        share = middle / looks
        state = (1.0 - share) * before + share * after
        reach = max(last - middle, middle - first) / looks * moved
        if not chords.meetings(state, reach):
            continue
        if middle > 0 and (met := chords.meetings(state)):
            raise Diverged("rod {} would go through rod {} on the way".format(*min(met)), 0, 0)
        if last - first > 1:
            parts += [(first, middle), (middle, last)]


@dataclass(frozen=True)
class Chords:
    """Straight pieces between neighbouring points on the true curves of all rods.

    Attributes:
        positions: Unknowns of the positions of all nodes, rod by rod, shape (num_nodes, 3).
        weights: Of nodes in points, rod by rod, shape (num_points, num_nodes).
        first: Point that each chord starts at, the next one being its end, shape (num_chords,).
        rod: Of each chord, shape (num_chords,).
        radius: Of each chord's rod as contact sees it, mm, shape (num_chords,).
        kept: Where on each chord, from 0 to 1, what counts begins and ends, shape (num_chords, 2): solids end in flat
            faces, which others touch near the centre line, and count from a radius away from them.
        closed: Whether each chord's rod is, shape (num_chords,).
        self_exclusion: Radii along a rod within which it does not meet itself.
        others: Whether a rod may meet others, shape (num_rods, num_rods).
    """

    positions: Ints
    weights: sp.csr_matrix
    first: Ints
    rod: Ints
    radius: Floats
    kept: Floats
    closed: npt.NDArray[np.bool_]
    self_exclusion: float
    others: npt.NDArray[np.bool_]

    @classmethod
    def of(cls, layout: Layout, contact: Contact, *states: Floats) -> Chords:
        """Chords near the true curves in some states, shape (num_unknowns,) each."""
        rods = range(len(layout.first))
        positions = np.concatenate([layout.unknowns(rod, slice(None))[:, :3] for rod in rods])
        parts = [curve_points(layout, rod, states) for rod in rods]
        owner = np.repeat(rods, [part.shape[0] for part in parts])
        first = np.flatnonzero(owner[1:] == owner[:-1])
        rod = owner[first]
        radius = layout.radius.copy()
        radius[layout.surface_rods[: len(contact.layout.radius)]] = contact.layout.radius
        exclusion = float(contact.pairing.search.self_exclusion)
        others = may_touch(contact) & (contact.layout.group is None)
        kept = np.concatenate([_kept(layout, rod, parts[rod]) for rod in rods])
        closed = np.isin(rod, list(layout.joints.rods))
        return cls(
            positions,
            sp.block_diag(parts, format="csr"),
            first,
            rod,
            radius[rod],
            kept,
            closed,
            exclusion,
            others,
        )

    def points(self, state: Floats) -> Floats:
        """Where they are in a state, or how far they are moved by a change of unknowns, shape (num_points, 3), mm."""
        return np.asarray(self.weights @ state[self.positions])

    def longest(self, state: Floats) -> float:
        """Length of the longest chord, mm."""
        points = self.points(state)
        return float(np.linalg.norm(points[self.first + 1] - points[self.first], axis=1).max())

    def meetings(
        self, state: Floats, motion: Floats | None = None, near: float = NEAR
    ) -> set[tuple[int, int]]:
        """Pairs of rods, the lower number first, that have chords too near each other in a state.

        Args:
            state: Unknowns, shape (num_unknowns,).
            motion: How far each point may move from there, shape (num_points,), mm; none by default.
            near: Distance that is too near, sums of radii.
        """
        may_move = np.zeros(self.weights.shape[0]) if motion is None else motion
        ways = np.maximum(may_move[self.first], may_move[self.first + 1])
        points = self.points(state)
        begin, way = points[self.first], points[self.first + 1] - points[self.first]
        length = np.linalg.norm(way, axis=1)
        begin, end = (begin + at[:, None] * way for at in self.kept.T)
        middle = (begin + end) / 2.0
        farthest = 2.0 * (near * self.radius.max() + ways.max()) + length.max()
        i, j = cKDTree(middle).query_pairs(farthest, output_type="ndarray").T
        limit = near * (self.radius[i] + self.radius[j]) + ways[i] + ways[j]
        reach = limit + (length[i] + length[j]) / 2.0
        asked = self._may_meet(i, j, length)
        asked &= (self.kept[i, 0] < self.kept[i, 1]) & (self.kept[j, 0] < self.kept[j, 1])
        asked &= np.linalg.norm(middle[i] - middle[j], axis=1) <= reach
        i, j = i[asked], j[asked]
        distances = chord_distances(begin[i], end[i], begin[j], end[j])
        near = distances < limit[asked]
        return set(zip(self.rod[i[near]].tolist(), self.rod[j[near]].tolist(), strict=True))

    def _may_meet(self, i: Ints, j: Ints, length: Floats) -> npt.NDArray[np.bool_]:
        """Whether chords i < j are of rods that may meet, or far from each other on one that may meet itself."""
        end, whole = np.cumsum(length), np.bincount(self.rod, length)
        apart = end[j] - length[j] - end[i]
        round_joint = whole[self.rod[i]] - apart - length[i] - length[j]
        apart = np.where(self.closed[i], np.minimum(apart, round_joint), apart)
        may_itself = apart > self.self_exclusion * self.radius[i]
        others = self.others[self.rod[i], self.rod[j]]
        return np.where(self.rod[i] == self.rod[j], may_itself, others)


def _kept(layout: Layout, rod: int, weights: sp.csr_matrix) -> Floats:
    """Where what counts of each chord of a rod begins and ends, shape (num_points - 1, 2)."""
    points = weights @ layout.rest[layout.unknowns(rod, slice(None))[:, :3]]
    length = np.linalg.norm(np.diff(points, axis=0), axis=1)
    arc = np.append(0.0, length.cumsum())
    face = layout.radius[rod] if rod in layout.sections else 0.0
    begin = (face - arc[:-1]) / length
    end = (arc[-1] - face - arc[:-1]) / length
    return np.clip(np.stack([begin, end], axis=1), 0.0, 1.0)
