"""Equilibria of beams that are folded: right for the discretised beam, wrong for any rod."""

from __future__ import annotations

import numpy as np

from ..solver.trial import Diverged
from ..system.terms import Floats
from .layout import Layout

# Slope of an element at its nodes, over the spans between nodes, from their positions.
SLOPES = {
    1: np.array([[-1.0, 1.0], [-1.0, 1.0]]),
    2: np.array([[-1.5, 2.0, -0.5], [-0.5, 0.0, 0.5], [0.5, -2.0, 1.5]]),
}


def refuse_folded(layout: Layout, q: Floats) -> None:
    """Where the axis runs backwards through its own section an element is turned inside out, and stays so.

    Args:
        q: Unknowns, shape (num_unknowns,).
    Raises:
        Diverged: If g1, g2 and x' of an element are not right-handed at each of its nodes.
    """
    for rod in range(len(layout.first)):
        if layout.block[rod] != 9:
            continue
        state = q[layout.unknowns(rod, slice(None))]
        degree = int(layout.degree[rod])
        normals = np.cross(state[:, 3:6], state[:, 6:9])
        first = np.arange(0, len(state) - 1, degree)
        nodes = first[:, None] + np.arange(degree + 1)
        slopes = np.einsum("ij,ejk->eik", SLOPES[degree], state[nodes, :3])
        through = np.einsum("eik,eik->ei", slopes, normals[nodes])
        if through.min() <= 0.0:
            element, at = np.unravel_index(through.argmin(), through.shape)
            raise Diverged(f"rod {rod} is folded at its node {nodes[element, at]}", 0, 0)
