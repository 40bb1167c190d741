"""Closed surfaces cut by planes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from braidx.output.arrays import Array, Integers
from braidx.output.skin_picture import SkinPicture


@dataclass(frozen=True)
class Slice:
    """One closed outline that a plane cuts from a surface."""

    outline: Array  # (n, 3), mm, in order, not repeated at the end
    owner: int  # yarn, -1 for the core


def slice_skin(skin: SkinPicture, origin: Array, normal: Array) -> list[Slice]:
    """Outlines of a skin in a plane, one or more per owner.

    A surface that is open, or that the plane leaves through its open end, gives no outline there.

    Args:
        skin: The surface.
        origin: A point of the plane, shape (3,), mm.
        normal: Normal of the plane, shape (3,).
    """
    corners, face = skin.triangles()
    height = (skin.points - origin) @ normal
    # No corner exactly in the plane: every cut triangle is then cut through two of its edges.
    height = np.where(height == 0.0, 1e-12, height)
    above = height > 0.0
    cut = np.flatnonzero(above[corners].any(axis=1) & ~above[corners].all(axis=1))
    edges = corners[cut][:, [[0, 1], [1, 2], [2, 0]]]  # (cut, 3, 2)
    crossed = above[edges[..., 0]] != above[edges[..., 1]]
    pairs = np.sort(edges[crossed].reshape(-1, 2), axis=1)  # two per triangle, in its order
    kinds, number = np.unique(pairs, axis=0, return_inverse=True)
    low, high = height[kinds[:, 0]], height[kinds[:, 1]]
    share = (low / (low - high))[:, None]
    points = (1 - share) * skin.points[kinds[:, 0]] + share * skin.points[kinds[:, 1]]
    links = number.reshape(-1, 2)
    owners = skin.owner[face[cut]]
    return [
        Slice(points[loop], int(owner))
        for owner in np.unique(owners)
        for loop in _loops(links[owners == owner])
    ]


def section_ratio(outline: Array) -> float:
    """Minor over major axis of an outline, by the second moments of its area; 1 for a circle.

    Args:
        outline: Points in order in any plane, shape (n, 3), mm.
    """
    middle = outline.mean(axis=0)
    _, _, directions = np.linalg.svd(outline - middle)
    p = (outline - middle) @ directions[:2].T
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    area = 0.5 * cross.sum()
    centre = ((p + q) * cross[:, None]).sum(axis=0) / (6.0 * area)
    # Integrals of x_i x_j over the polygon, triangle by triangle from the origin.
    both = np.einsum("ni,nj->nij", p, p) + np.einsum("ni,nj->nij", q, q)
    both += np.einsum("ni,nj->nij", p + q, p + q)
    moments = (cross[:, None, None] * both).sum(axis=0) / (24.0 * area) - np.outer(centre, centre)
    least, most = np.linalg.eigvalsh(moments)
    return float(np.sqrt(max(least, 0.0) / most))


def _loops(links: Integers) -> list[Integers]:
    """Closed walks along links between points; walks that end somewhere are left out."""
    neighbours: dict[int, list[int]] = {}
    for pair in links:
        one, two = int(pair[0]), int(pair[1])
        neighbours.setdefault(one, []).append(two)
        neighbours.setdefault(two, []).append(one)
    loops = []
    left = set(neighbours)
    while left:
        start = left.pop()
        walk, here, before = [start], start, -1
        closed = False
        while True:
            onward = [point for point in neighbours[here] if point != before]
            if not onward or len(neighbours[here]) != 2:
                break
            before, here = here, onward[0]
            if here == start:
                closed = True
                break
            if here not in left:
                break
            left.discard(here)
            walk.append(here)
        if closed and len(walk) > 2:
            loops.append(np.array(walk, dtype=np.int64))
    return loops
