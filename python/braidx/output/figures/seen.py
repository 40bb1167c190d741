"""What each pixel of a view sees, whatever it is a picture of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.output.figures.raycast import Tubes, View, cast
from braidx.output.figures.triangles import Triangles, joined, rasterise
from braidx.output.snapshot import Array


@dataclass(frozen=True)
class Seen:
    """Arrays of the picture's shape (rows, columns)."""

    depth: Array  # mm towards the eye; -inf where nothing is seen
    colour: Array  # (rows, columns, 3), red, green, blue, 0..1
    normal: Array  # (rows, columns, 3), in the frame of the view
    is_cut: NDArray[np.bool_]

    @property
    def covered(self) -> NDArray[np.bool_]:
        """Where anything is seen."""
        return np.isfinite(self.depth)


def see(parts: Sequence[Tubes | Triangles], view: View) -> Seen:
    """The nearest of all parts per pixel; of two at equal depth the later one."""
    shape = view.shape
    depth, is_cut = np.full(shape, -np.inf), np.zeros(shape, dtype=bool)
    colour, normal = np.zeros((*shape, 3)), np.zeros((*shape, 3))
    surfaces = [part for part in parts if isinstance(part, Triangles)]
    if len(surfaces) > 1:  # much faster
        parts = [part for part in parts if isinstance(part, Tubes)] + [joined(surfaces)]
    for part in parts:
        one = _see_tubes(part, view) if isinstance(part, Tubes) else _see_triangles(part, view)
        front = one.covered & (one.depth >= depth)
        depth[front], is_cut[front] = one.depth[front], one.is_cut[front]
        colour[front], normal[front] = one.colour[front], one.normal[front]
    return Seen(depth, colour, normal, is_cut)


def _see_tubes(tubes: Tubes, view: View) -> Seen:
    hits = cast(tubes, view)
    return Seen(hits.depth, tubes.colour[hits.cylinder], hits.normal, hits.is_cut)


def _see_triangles(triangles: Triangles, view: View) -> Seen:
    fragments = rasterise(triangles, view)
    colour = triangles.colour[fragments.triangle]
    if triangles.inside is not None:
        cut = fragments.is_cut
        colour[cut] = triangles.inside[fragments.triangle[cut]]
    return Seen(fragments.depth, colour, fragments.normal, fragments.is_cut)
