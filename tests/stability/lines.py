"""How near centre lines come to each other, measured without the library's own contact search."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from braidx.rods import Rods

Floats = npt.NDArray[np.float64]
REACH = 1.2  # sums of radii: what is farther is not near
FINER, POINTS = 6, 8  # points of a line per element of degree 1, and of degree 2
SUBSTEPS = 16  # places on the way of an increment that are looked at


def centre_line(nodes: Floats, degree: int) -> Floats:
    """Points of a centre line, shape (n, 3), mm: so many per element that chords hardly cut corners of tight loops.

    Args:
        nodes: Shape (num_nodes, 3), mm.
        degree: Of the elements between them; of degree 1, contact takes smooth lines through the nodes.
    """
    if degree == 1:
        return smooth(nodes, False)
    a, b, c = nodes[:-1:2], nodes[1::2], nodes[2::2]
    s = (np.arange(POINTS) / POINTS)[:, None, None]
    inner = (1 - s) * (1 - 2 * s) * a + 4 * s * (1 - s) * b + s * (2 * s - 1) * c
    return np.vstack([inner.transpose(1, 0, 2).reshape(-1, 3), nodes[-1:]])


def smooth(line: Floats, goes_on: bool) -> Floats:
    """Points of the Catmull-Rom spline through nodes of shape (n, 3), mm: what yarns are to contact (docs/theory.md).

    Args:
        goes_on: Whether the line repeats itself past its ends; else its last spans are parabolas through three nodes.
    """
    period = line[-1] - line[0]
    before = line[-2] - period if goes_on else 3.0 * (line[0] - line[1]) + line[2]
    after = line[1] + period if goes_on else 3.0 * (line[-1] - line[-2]) + line[-3]
    p = np.vstack([before, line, after])[:, None]
    t = np.linspace(0.0, 1.0, FINER, endpoint=False)[:, None]
    a, b, c, d = p[:-3], p[1:-2], p[2:-1], p[3:]
    cubic = 2.0 * a - 5.0 * b + 4.0 * c - d, 3.0 * (b - c) + d - a
    points = b + t / 2.0 * (c - a + t * (cubic[0] + t * cubic[1]))
    return np.vstack([points.reshape(-1, 3), line[-1:]])


def segment_distances(a: Floats, b: Floats, ends_a: Floats, ends_b: Floats) -> Floats:
    """Distances of segments from a to ends_a from others, from b to ends_b; all shapes (n, 3), mm."""
    u, v, w = ends_a - a, ends_b - b, a - b
    uu, vv, uv = (u * u).sum(-1), (v * v).sum(-1), (u * v).sum(-1)
    uw, vw = (u * w).sum(-1), (v * w).sum(-1)
    det = np.maximum(uu * vv - uv**2, 1e-12 * uu * vv)
    s = np.clip((uv * vw - vv * uw) / det, 0.0, 1.0)
    t = np.clip((uv * s + vw) / vv, 0.0, 1.0)
    s = np.clip((uv * t - uw) / uu, 0.0, 1.0)
    return np.asarray(np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=-1))


def near_segments(a: Floats, b: Floats, reach: float) -> tuple[Floats, npt.NDArray[np.int64]]:
    """Distances of segments of two polylines, shape (n,), and which they are, shape (n, 2).

    Args:
        a, b: Points, shapes (na, 3) and (nb, 3), mm.
        reach: Distance up to which all are found, mm.
    """
    middles = [(line[1:] + line[:-1]) / 2.0 for line in (a, b)]
    longest = [float(np.linalg.norm(np.diff(line, axis=0), axis=1).max()) for line in (a, b)]
    found = cKDTree(middles[0]).query_ball_tree(cKDTree(middles[1]), reach + sum(longest) / 2.0)
    which = np.array([(i, j) for i, row in enumerate(found) for j in row], dtype=np.int64)
    i, j = which.reshape(-1, 2).T
    return segment_distances(a[i], b[j], a[i + 1], b[j + 1]), which.reshape(-1, 2)


def pairs(rods: Rods) -> list[tuple[int, int]]:
    """Rods that may touch, with those that may touch themselves."""
    number = len(rods.rods)
    both = [(i, j) for i in range(number) for j in range(i + 1, number)]
    exclusion = rods.contact.pairing.search.self_exclusion
    return both + ([(i, i) for i in range(number)] if np.isfinite(exclusion) else [])


def nearness(rods: Rods, lines: Sequence[Floats], widths: Sequence[Floats] | None = None) -> float:
    """Smallest distance of centre lines over the sum of radii, REACH at most; rods that touch have 1.

    Args:
        lines: Points of each rod, shape (n, 3), mm.
        widths: Tensors of the half widths of each (rope_lines.half_widths), shape (n - 1, 3, 3), mm^2, which then
            count instead of radii.
    """
    least = REACH
    for i, j in pairs(rods):
        both: float | Floats = rods.rods[i].radius + rods.rods[j].radius
        distance, which = near_segments(lines[i], lines[j], REACH * both)
        if widths is not None:
            both = _across(lines[i], lines[j], widths[i], widths[j], which)
        near = distance / both
        if i == j:
            arc = np.append(0.0, np.linalg.norm(np.diff(lines[i], axis=0), axis=1).cumsum())
            away = rods.contact.pairing.search.self_exclusion * rods.rods[i].radius
            near = near[np.abs(arc[which[:, 0]] - arc[which[:, 1]]) > away]
        least = min(least, float(near.min(initial=np.inf)))
    return least


def _across(
    a: Floats, b: Floats, widths_a: Floats, widths_b: Floats, which: npt.NDArray[np.int64]
) -> Floats:
    """Half widths of pairs of segments, along the way from middle to middle, in all; shape (n,), mm."""
    i, j = which.T
    way = (b[j] + b[j + 1] - a[i] - a[i + 1]) / 2.0
    way /= np.maximum(np.linalg.norm(way, axis=1), 1e-12)[:, None]
    along = [np.einsum("ni,nij,nj->n", way, w, way) for w in (widths_a[i], widths_b[j])]
    return np.asarray(np.sqrt(along[0]) + np.sqrt(along[1]))


def nearness_on_the_way(rods: Rods, begin: Sequence[Floats], end: Sequence[Floats]) -> float:
    """The same, the least of all states on the straight way between two: 0 where a rod goes through another."""
    return min(
        nearness(rods, [(1 - s) * a + s * b for a, b in zip(begin, end, strict=True)])
        for s in np.linspace(0.0, 1.0, SUBSTEPS + 1)
    )
