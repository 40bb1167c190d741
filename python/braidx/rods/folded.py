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

KINK = 0.5  # radians that sections turn by between two nodes, and
SHARPER = 3.0  # times what they turn by on either side, from which on a beam is kinked: couples do not jump like this


def refuse_kinked(layout: Layout, q: Floats) -> None:
    """A beam bent to nearly its radius is softer where it is bent more: it may gather its bend between two nodes.

    Long increments get there although there is an equilibrium with the bend spread out.

    Args:
        q: Unknowns, shape (num_unknowns,).
    Raises:
        Diverged: If sections turn between two nodes by far more than between their neighbours on both sides.
    """
    for rod in np.flatnonzero(layout.block == 9):
        unknowns = layout.unknowns(int(rod), slice(None))
        turns = np.abs(_turns(q[unknowns]) - _turns(layout.rest[unknowns]))
        if len(turns) < 3:
            continue
        beside = np.maximum(turns[:-2], turns[2:])
        kinked = (turns[1:-1] > KINK) & (turns[1:-1] > SHARPER * beside)
        if kinked.any():
            raise Diverged(f"rod {rod} is kinked after its node {1 + int(kinked.argmax())}", 0, 0)


def _turns(state: Floats) -> Floats:
    """Angles between the normals of sections of neighbouring nodes, shape (num_nodes - 1,)."""
    normals = np.cross(state[:, 3:6], state[:, 6:9])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    sines = np.linalg.norm(np.cross(normals[:-1], normals[1:]), axis=1)
    return np.asarray(np.arctan2(sines, (normals[:-1] * normals[1:]).sum(axis=1)))


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
