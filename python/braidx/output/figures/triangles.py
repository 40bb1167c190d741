"""Pictures of closed surfaces: triangles drawn into a depth buffer, with NumPy only.

Where a cutting plane z = const of the view takes away the near side of a closed surface, a ray beyond
the plane leaves the solid once more than it enters it: there the plane runs through the solid, and the
cut face is drawn. So it does where solids that touch are in each other by a little.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.output.figures.raycast import View, ranges
from braidx.output.snapshot import Array

_CHUNK = 2_000_000  # pixels looked at together, roughly


@dataclass(frozen=True)
class Triangles:
    """Triangles with smooth normals; corners go round against the clock as seen from outside."""

    points: Array  # (n, 3), mm
    normals: Array  # (n, 3), unit, outward
    corners: NDArray[np.int64]  # (m, 3)
    colour: Array  # (m, 3), red, green, blue, 0..1
    inside: Array | None = None  # (m, 3), of cut faces by the triangle behind them; None: `colour`


@dataclass(frozen=True)
class Fragments:
    """What each pixel sees of triangles, arrays of the picture's shape (rows, columns)."""

    depth: Array  # mm towards the eye; -inf where the ray meets nothing
    triangle: NDArray[np.int64]  # -1 where the ray meets nothing
    is_cut: NDArray[np.bool_]
    normal: Array  # (rows, columns, 3), in the frame of the view


def joined(parts: Sequence[Triangles]) -> Triangles:
    """Several surfaces as one."""
    offsets = np.cumsum([0, *(len(part.points) for part in parts)])
    return Triangles(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.corners + offset for part, offset in zip(parts, offsets)]),
        np.concatenate([part.colour for part in parts]),
        np.concatenate([p.colour if p.inside is None else p.inside for p in parts]),
    )


def smooth_normals(points: Array, corners: NDArray[np.int64]) -> Array:
    """Normals at points: mean of the triangles there, weighted by area, shape (n, 3)."""
    a, b, c = points[corners].transpose(1, 0, 2)
    area = np.cross(b - a, c - a)
    total = np.zeros_like(points)
    for corner in corners.T:
        np.add.at(total, corner, area)
    normals: Array = total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-300)
    return normals


def rasterise(triangles: Triangles, view: View) -> Fragments:
    """Draw triangles; the first row of the picture is the top one."""
    rows, columns = view.shape
    place = (triangles.points - view.centre) @ view.axes.T
    pixels = place.copy()
    pixels[:, 0] = (place[:, 0] + 0.5 * view.width) * view.pixels_per_mm - 0.5
    pixels[:, 1] = (place[:, 1] + 0.5 * view.height) * view.pixels_per_mm - 0.5
    depth = np.full(rows * columns, -np.inf)
    nearest = np.full(rows * columns, -1, dtype=np.int64)
    share = np.zeros((rows * columns, 3))
    front_facing = np.zeros(rows * columns, dtype=bool)
    inside = _Inside(rows * columns)
    corner = pixels[triangles.corners]  # (m, 3 corners, 3)
    edge_1, edge_2 = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    double_area = edge_1[:, 0] * edge_2[:, 1] - edge_1[:, 1] * edge_2[:, 0]
    for chunk in _chunks(corner, double_area, (rows, columns)):
        who, column, row = _boxes(corner, chunk, (rows, columns))
        x, y = column - corner[who, 0, 0], row - corner[who, 0, 1]
        second = (x * edge_2[who, 1] - y * edge_2[who, 0]) / double_area[who]
        third = (y * edge_1[who, 0] - x * edge_1[who, 1]) / double_area[who]
        z = corner[who, 0, 2] + second * edge_1[who, 2] + third * edge_2[who, 2]
        pixel = row * columns + column
        hit = (second >= 0) & (third >= 0) & (second + third <= 1) & (z <= view.cut_depth)
        if np.isfinite(view.cut_depth):
            inside.count(pixel[hit], who[hit], z[hit], double_area[who[hit]] < 0)
        hit &= z > depth[pixel]
        who, z, second, third, pixel = who[hit], z[hit], second[hit], third[hit], pixel[hit]
        np.maximum.at(depth, pixel, z)
        front = np.flatnonzero(z == depth[pixel])
        pixel, who = pixel[front], who[front]
        nearest[pixel] = who
        share[pixel] = np.stack([1 - second - third, second, third], axis=1)[front]
        front_facing[pixel] = double_area[who] > 0
    is_cut = inside.depth > 0
    nearest[is_cut] = inside.behind[is_cut]
    depth[is_cut] = view.cut_depth
    normal = np.zeros((rows * columns, 3))
    at = np.flatnonzero(nearest >= 0)
    corner_normals = triangles.normals[triangles.corners[nearest[at]]]
    normal[at] = np.einsum("pk,pkc->pc", share[at], corner_normals) @ view.axes.T
    normal[at] *= np.where(front_facing[at], 1.0, -1.0)[:, None]  # seen from inside
    normal[at] /= np.maximum(np.linalg.norm(normal[at], axis=1, keepdims=True), 1e-12)
    normal[is_cut] = (0.0, 0.0, 1.0)
    shape = (rows, columns)
    return Fragments(
        depth.reshape(shape)[::-1],
        nearest.reshape(shape)[::-1],
        is_cut.reshape(shape)[::-1],
        normal.reshape(*shape, 3)[::-1],
    )


class _Inside:
    """How many closed surfaces the plane is inside of where each pixel's ray meets it.

    Attributes:
        depth: Their number, shape (num_pixels,).
        behind: The triangle through which the ray leaves the first of them, shape (num_pixels,).
    """

    def __init__(self, num_pixels: int) -> None:
        self.depth = np.zeros(num_pixels, dtype=np.int64)
        self.behind = np.full(num_pixels, -1, dtype=np.int64)
        self._nearest = np.full(num_pixels, -np.inf)

    def count(
        self, pixel: NDArray[np.int64], who: NDArray[np.int64], z: Array, leaves: NDArray[np.bool_]
    ) -> None:
        """Takes in what rays meet beyond the plane: pixel, triangle, depth, and whether the ray leaves there."""
        np.add.at(self.depth, pixel, np.where(leaves, 1, -1))
        pixel, who, z = pixel[leaves], who[leaves], z[leaves]
        np.maximum.at(self._nearest, pixel, z)
        first = z == self._nearest[pixel]
        self.behind[pixel[first]] = who[first]


def _limits(corner: Array, axis: int, size: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First pixel and number of pixels of each triangle's box along one axis of the picture."""
    first = np.clip(np.ceil(corner[:, :, axis].min(axis=1)), 0, size).astype(np.int64)
    end = np.clip(np.floor(corner[:, :, axis].max(axis=1)) + 1, 0, size).astype(np.int64)
    return first, np.maximum(end - first, 0)


def _chunks(corner: Array, double_area: Array, shape: tuple[int, int]) -> list[NDArray[np.int64]]:
    """Triangles that cover pixels, nearest first, in portions of about _CHUNK pixels."""
    count = _limits(corner, 0, shape[1])[1] * _limits(corner, 1, shape[0])[1]
    order = np.argsort(-corner[:, :, 2].max(axis=1), kind="stable")
    order = order[(count[order] > 0) & (double_area[order] != 0.0)]
    group = np.cumsum(count[order]) // _CHUNK
    return np.split(order, np.flatnonzero(np.diff(group)) + 1)


def _boxes(
    corner: Array, chunk: NDArray[np.int64], shape: tuple[int, int]
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Triangle, column and row of all pixels in the boxes of some triangles."""
    first_column, num_columns = _limits(corner[chunk], 0, shape[1])
    first_row, num_rows = _limits(corner[chunk], 1, shape[0])
    inside, column = ranges(np.arange(len(chunk)), first_column, num_columns)
    pair, row = ranges(np.arange(len(inside)), first_row[inside], num_rows[inside])
    return chunk[inside[pair]], column[pair], row
