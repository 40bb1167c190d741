"""Places along rods: nodes, and points between them."""

from __future__ import annotations

import numpy as np

from ..system.terms import Floats, Ints
from .layout import Layout

Place = tuple[int, float]  # rod, and where along it by the numbers of its nodes


def place_of(layout: Layout, place: Place) -> tuple[Ints, Floats]:
    """Nodes whose unknowns make those of a place, shape (k, block), and their weights, shape (k,).

    Negative integers count nodes from the end.

    Raises:
        IndexError: If there is no such rod or place.
    """
    rod, at = place
    if float(at).is_integer():
        return layout.unknowns(rod, int(at)), np.ones(1)
    if not 0 <= rod < len(layout.first):
        layout.unknowns(rod, 0)
        raise IndexError(f"place {at} of {rod}: a rigid group has one node, 0")
    last, degree = int(layout.num_nodes[rod]) - 1, int(layout.degree[rod])
    if not 0.0 < at < last:
        raise IndexError(f"place {at} of rod {rod}: give a number from 0 to {last}, as nodes have")
    begin = degree * int(at / degree)
    t = (at - begin) / degree
    weights = (
        [1 - t, t] if degree == 1 else [(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)]
    )
    return layout.unknowns(rod, list(range(begin, begin + degree + 1))), np.array(weights)
