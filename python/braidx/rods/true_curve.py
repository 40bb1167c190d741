"""Points on the true curves of rods, which chords between nodes cut short where elements are bent."""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from ..system.terms import Floats
from .layout import Layout

FLAT = 0.1  # radii that chords may be off the curve: little beside the half sums of radii that tell a passage
MOST = 16  # points of a span between nodes: what asks for more has lost its shape


def curve_points(layout: Layout, rod: int, states: tuple[Floats, ...]) -> sp.csr_matrix:
    """Weights of the nodes of a rod in points on its curve, dense enough for chords between them in some states.

    Returns:
        Shape (num_points, num_nodes); every num_spans-th point is a node, and all are where the rod hardly bends.
    """
    count, num_nodes = 1, int(layout.num_nodes[rod])
    for state in states:
        nodes = state[layout.unknowns(rod, slice(None))[:, :3]]
        # Second derivatives per span are at most three second differences, and sagittas an eighth of those.
        kink = np.linalg.norm(np.diff(nodes, 2, axis=0), axis=1).max(initial=0.0)
        count = max(
            count, int(min(MOST, np.ceil(np.sqrt(0.375 * kink / (FLAT * layout.radius[rod])))))
        )
    if count == 1:
        return sp.identity(num_nodes, format="csr")
    return sp.csr_matrix(interpolated(np.eye(num_nodes), int(layout.degree[rod]), count))


def interpolated(nodes: Floats, degree: int, count: int) -> Floats:
    """Points on a curve, `count` per span between nodes and the last node, from nodes of shape (num_nodes, m).

    Elements of degree 2 are what their shape functions say; those of degree 1 are joined by Catmull-Rom splines, as in
    contact (contact_engine/surfaces/tube.h).
    """
    if degree == 2:
        t = np.arange(2 * count)[:, None, None] / (2 * count)
        a, b, c = nodes[:-2:2], nodes[1:-1:2], nodes[2::2]
        inner = (1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * b + t * (2 * t - 1) * c
    else:
        t = np.arange(count)[:, None, None] / count
        a, b = nodes[:-1], nodes[1:]
        slopes = np.gradient(nodes, axis=0, edge_order=2 if len(nodes) > 2 else 1)
        inner = (1 + 2 * t) * (1 - t) ** 2 * a + t * t * (3 - 2 * t) * b
        inner = inner + t * (1 - t) ** 2 * slopes[:-1] - t * t * (1 - t) * slopes[1:]
    return np.concatenate([np.swapaxes(inner, 0, 1).reshape(-1, nodes.shape[1]), nodes[-1:]])
