"""Directors of curves: frames that turn with the tangent and do not spin about it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def nodal_tangents(line: FloatArray) -> FloatArray:
    """Unit tangents at the nodes, second order on uneven nodes too; shapes (num_nodes, 3)."""
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    slopes = np.gradient(line, arc, axis=0, edge_order=2 if len(line) > 2 else 1)
    return slopes / np.linalg.norm(slopes, axis=1, keepdims=True)


def rotation_minimising_frames(
    centre_lines: Sequence[FloatArray], first: FloatArray | None = None
) -> tuple[FloatArray, ...]:
    """Orthonormal directors of each curve, perpendicular to it and free of spin.

    Source: Wang, Juettler, Zheng, Liu, Computation of rotation minimizing frames (2008): double
        reflection; all
    curves advance together, so that the loop has as many steps as the longest one has nodes.

    Args:
        centre_lines: Nodes of each curve, shape (num_nodes_i, 3), mm.
        first: Direction that director 1 starts from on each curve, shape (num_curves, 3), made
            perpendicular to it; by default the axis of space most perpendicular to it.
    Returns:
        Directors (g1, g2) of each curve, shape (num_nodes_i, 2, 3), right-handed with the tangent:
        g1 x g2 = t.
    """
    counts = np.array([len(line) for line in centre_lines])
    tangents, points = (np.zeros((len(counts), counts.max(), 3)) for _ in range(2))
    for i, line in enumerate(centre_lines):
        tangents[i, : counts[i]] = nodal_tangents(np.asarray(line, dtype=np.float64))
        points[i, : counts[i]] = line
    start = tangents[:, 0]
    if first is None:
        first = np.eye(3)[np.abs(start).argmin(axis=1)]
    directors = np.zeros_like(tangents)
    directors[:, 0] = _perpendicular(first, start)
    for node in range(1, counts.max()):
        step = points[:, node] - points[:, node - 1]
        carried = _reflect(directors[:, node - 1], step)
        turned = _reflect(tangents[:, node - 1], step)
        carried = _reflect(carried, tangents[:, node] - turned)
        directors[:, node] = np.where(
            (node < counts)[:, None], _perpendicular(carried, tangents[:, node]), carried
        )
    return tuple(
        np.stack([g[:n], np.cross(t[:n], g[:n])], axis=1)
        for g, t, n in zip(directors, tangents, counts)
    )


def check_right_handed(line: FloatArray, directors: FloatArray, name: str) -> None:
    """Refuses directors, shape (num_nodes, 2, 3), that are no right-handed frame with the tangent of their line.

    Raises:
        ValueError: If g1 x g2 does not point along the line; the message begins with the name.
    """
    if directors.shape != (len(line), 2, 3):
        raise ValueError(f"{name} have shape {directors.shape}: give ({len(line)}, 2, 3)")
    along = (np.cross(directors[:, 0], directors[:, 1]) * nodal_tangents(line)).sum(axis=1)
    if not along.min() > 0.0:
        raise ValueError(
            f"{name} are left-handed at node {along.argmin()}: g1 x g2 must point along the line; swap g1 and g2, or "
            "change the sign of one of them"
        )


def _reflect(vectors: FloatArray, normals: FloatArray) -> FloatArray:
    """Reflect at the planes with these normals; a zero normal leaves the vector, shapes (n, 3)."""
    square = np.sum(normals**2, axis=1)
    along = np.sum(vectors * normals, axis=1)
    factor = np.divide(2.0 * along, square, out=np.zeros_like(square), where=square > 0.0)
    return vectors - factor[:, None] * normals


def _perpendicular(vectors: FloatArray, tangents: FloatArray) -> FloatArray:
    """Unit vectors perpendicular to the tangents, nearest to `vectors`, shapes (n, 3)."""
    rest = vectors - np.sum(vectors * tangents, axis=1, keepdims=True) * tangents
    size = np.linalg.norm(rest, axis=1, keepdims=True)
    return np.divide(rest, size, out=np.zeros_like(rest), where=size > 0.0)
