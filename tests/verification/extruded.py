"""Meshes of one layer of hexahedra for plane strain."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from braidx.meshing import SolidMesh, sweep
from braidx.meshing.reference import QUADS
from braidx.meshing.section import SectionMesh

Floats = npt.NDArray[np.float64]


def graded(fine: float, extent: float, end: float, growth: float) -> Floats:
    """Places 0 to `end`: steps of `fine` up to `extent` at least, growing by a factor beyond, shape (n,)."""
    places, step = [0.0], fine
    while places[-1] < end:
        step = fine if places[-1] < extent else step * growth
        places.append(places[-1] + step)
    last = np.array(places)
    beyond = last > extent
    # The last place is the end: what lies beyond `extent` is drawn together a little.
    last[beyond] = extent + (last[beyond] - extent) * (end - extent) / (last[-1] - extent)
    return last


def slab(
    place: Callable[[Floats, Floats], Any], u: Floats, v: Floats, thickness: float, degree: int
) -> SolidMesh:
    """Quadrilaterals of a map of (u, v), extruded along z; one layer.

    Args:
        place: x and y of places (u, v), right-handed.
        u, v: Corners of the quadrilaterals.
    Returns:
        Mesh with the surfaces "south" (first v) and "north" (last v).
    """
    finer = [
        np.interp(np.arange(degree * (len(w) - 1) + 1) / degree, np.arange(len(w)), w)
        for w in (u, v)
    ]
    grid = np.meshgrid(*finer, indexing="ij")
    points = np.stack(place(*grid), axis=-1).reshape(-1, 2)
    counts = len(u) - 1, len(v) - 1
    corner = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(
        -1, 1, 2
    )
    at = degree * corner + np.round(degree * QUADS[degree].points).astype(np.int64)
    quads = at[..., 0] * len(finer[1]) + at[..., 1]
    south = [(i * counts[1], 0) for i in range(counts[0])]
    north = [((i + 1) * counts[1] - 1, 3) for i in range(counts[0])]
    section = SectionMesh(points, quads, np.array(south + north), np.empty((0, 2), dtype=np.int64))
    line = np.zeros((degree + 1, 3))
    line[:, 2] = np.linspace(0.0, thickness, degree + 1)
    mesh = sweep(line, section, np.broadcast_to(np.eye(3)[:2], (degree + 1, 2, 3)))
    faces = mesh.facets["lateral"]
    return replace(mesh, facets={"south": faces[: counts[0]], "north": faces[counts[0] :]})


def round_bottom(
    radius: float, fine: float, extent: float, thickness: float, degree: int, below: bool = False
) -> SolidMesh:
    """Right half of a half cylinder that stands on its round side at the origin, its flat side at y = radius.

    The tip beyond 60 degrees, which carries nothing, is left out.

    Args:
        fine: Size of elements where |x| < `extent`; they grow from there, mm.
        below: Mirrored at y = 0.
    Returns:
        Mesh with the round surface "south" and the flat one "north".
    """
    end = np.pi / 3

    def place(u: Floats, v: Floats) -> tuple[Floats, Floats]:
        x, y = radius * np.sin(np.abs(u) / radius), radius * (1.0 - np.cos(u / radius))
        top = radius * np.sin(end) * np.abs(u) / (radius * end)
        y = y + (radius - y) * v / radius
        return x + (top - x) * v / radius, -y if below else y

    growth = 1.25**degree
    along = graded(fine, extent, radius * end, growth)
    if below:  # turns the map round, so that it stays right-handed
        along = -along[::-1]
    return slab(place, along, graded(fine, 0.5 * extent, radius, growth), thickness, degree)
