"""Centre lines of simple shapes, for verification cases. Lengths in mm, angles in radians."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def straight(start: ArrayLike, end: ArrayLike, num_nodes: int) -> Array:
    """Equidistant nodes from start to end, shape (num_nodes, 3)."""
    return np.linspace(np.asarray(start, float), np.asarray(end, float), num_nodes)


def arc(radius: float, angle: float, num_nodes: int) -> Array:
    """Arc in the x-y plane from the origin, tangent to x and turning towards y, (num_nodes, 3)."""
    turn = np.linspace(0.0, angle, num_nodes)
    return np.column_stack(
        [radius * np.sin(turn), radius * (1.0 - np.cos(turn)), np.zeros(num_nodes)]
    )


def helix(radius: float, pitch: float, length: float, num_nodes: int, phase: float = 0.0) -> Array:
    """Helix around z with nodes uniform in z from 0 to length, shape (num_nodes, 3).

    A positive pitch turns right-handed, a negative one left-handed.
    """
    z = np.linspace(0.0, length, num_nodes)
    angle = phase + 2.0 * np.pi * z / pitch
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])


def ring(radius: float, num_elements: int) -> Array:
    """Closed circle around z, shape (num_elements + 1, 3); the last node is the first."""
    angle = np.linspace(0.0, 2.0 * np.pi, num_elements + 1)
    nodes = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros_like(angle)])
    nodes[-1] = nodes[0]
    return nodes
