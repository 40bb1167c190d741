"""Increments in which rods would go through each other unseen: contact knows only what is near at their ends."""

from __future__ import annotations

import numpy as np
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
    lines = [layout.unknowns(rod, slice(None))[:, :3] for rod in range(len(layout.first))]
    moved = max(float(np.linalg.norm((after - before)[line], axis=1).max()) for line in lines)
    looks = min(MOST, int(moved / (PACE * contact.min_radius)))
    if looks < 2:
        return

    def meet(state: Floats, a: int, b: int) -> bool:
        return _meet(layout, contact, state[lines[a]], state[lines[b]], a, b)

    # What overlaps to begin with, as the ends of a ring do, says nothing of the way.
    apart = [pair for pair in _pairs(contact) if not meet(before, *pair)]
    for share in np.arange(1, looks) / looks:
        for a, b in apart:
            if meet((1.0 - share) * before + share * after, a, b):
                raise Diverged(f"rod {a} would go through rod {b} on the way", 0, 0)


def _pairs(contact: Contact) -> list[tuple[int, int]]:
    """Rods that may touch each other, or may touch themselves."""
    groups = contact.layout.group
    number = len(contact.layout.radius)
    themselves = np.isfinite(contact.pairing.search.self_exclusion)
    return [
        (a, b)
        for a in range(number)
        for b in range(a, number)
        if (themselves if a == b else groups is None)
    ]


def _meet(layout: Layout, contact: Contact, a: Floats, b: Floats, rod: int, other: int) -> bool:
    """Whether chords of two lines, shapes (na, 3) and (nb, 3), are too near each other."""
    radius = layout.tubes.radius
    limit = NEAR * float(radius[rod] + radius[other])
    chords = [np.linalg.norm(np.diff(line, axis=0), axis=1) for line in (a, b)]
    reach = limit + (chords[0].max() + chords[1].max()) / 2.0
    trees = [cKDTree((line[1:] + line[:-1]) / 2.0) for line in (a, b)]
    near = trees[0].sparse_distance_matrix(trees[1], reach, output_type="coo_matrix")
    i, j = near.row, near.col
    if rod == other:
        arc = np.append(0.0, chords[0].cumsum())
        apart = np.abs(arc[i] - arc[j]) > contact.pairing.search.self_exclusion * radius[rod]
        i, j = i[apart], j[apart]
    return bool(np.any(_distances(a, b, i, j) < limit))


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
