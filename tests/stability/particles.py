"""How far apart the particles are that friction acts on, for the couples that it leaves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from braidx.rods import Beam, Rods

Floats = npt.NDArray[np.float64]


def apart(rods: Rods, touching: Mapping[str, npt.NDArray[Any]]) -> Floats:
    """Distance of the two particles of each contact between rods, shape (m,), mm; a penetration, and what sections that
    do not contain the normal add. On rigid surfaces, the penetration.

    Args:
        rods: The scene.
        touching: Its contacts.
    """
    distance = np.abs(touching["gap"])
    between = np.flatnonzero(touching["tubes"][:, 1] >= 0)
    sides = [
        _particles(rods, touching, between, side, slice(2 * side, 2 * side + 2)) for side in (0, 1)
    ]
    distance[between] = np.linalg.norm(sides[1] - sides[0], axis=1)
    return np.asarray(distance)


def _particles(
    rods: Rods, touching: Mapping[str, Any], rows: npt.NDArray[np.int64], side: int, arms: slice
) -> Floats:
    places, number = np.zeros((len(rows), 3)), touching["tubes"][rows, side]
    for rod in np.unique(number):
        mine = np.flatnonzero(number == rod)
        model = rods.rods[rod]
        unknowns = rods.layout.unknowns(int(rod), slice(None))
        nodes = rods.q[unknowns].reshape(len(unknowns), -1)
        s = touching["s"][rows[mine], side]
        places[mine] = on_line(nodes[:, :3], s, model.degree, smooth=True)
        if isinstance(model, Beam):
            g = on_line(nodes[:, 3:], s, model.degree, smooth=False).reshape(-1, 2, 3)
            places[mine] += np.einsum("mk,mki->mi", touching["xi"][rows[mine], arms], g)
    return places


def on_line(nodes: Floats, s: Floats, degree: int, smooth: bool) -> Floats:
    """Values between nodes, shape (num_nodes, k), at s, shape (m,), in elements; shape (m, k).

    Args:
        nodes, s: As above.
        degree: Of the elements.
        smooth: Whether those of degree 1 are Catmull-Rom splines, parabolas at ends, instead of straight lines.
    """
    count = (len(nodes) - 1) // degree
    element = np.clip(np.floor(s).astype(int), 0, count - 1)
    t = (s - element)[:, None]
    if degree == 2:
        a, b, c = (nodes[2 * element + k] for k in range(3))
        return np.asarray((1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * b + t * (2 * t - 1) * c)
    if not smooth:
        return np.asarray((1 - t) * nodes[element] + t * nodes[element + 1])
    before, after = (3 * (a - b) + c for a, b, c in (nodes[:3], nodes[:-4:-1]))
    all_ = np.vstack([before, nodes, after])
    a, b, c, d = (all_[element + k] for k in range(4))
    cubic = 2 * a - 5 * b + 4 * c - d, 3 * (b - c) + d - a
    return np.asarray(b + t / 2 * (c - a + t * (cubic[0] + t * cubic[1])))
