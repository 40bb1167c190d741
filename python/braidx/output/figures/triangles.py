"""Pictures of closed surfaces: triangles drawn into a depth buffer, with NumPy only.

A triangle covers a span of pixels in each row; depth is linear along it. Where a cutting plane z = const of the view
takes away the near side of a closed surface, a ray beyond the plane leaves the solid once more than it enters it:
there the plane runs through the solid, and the cut face is drawn. So it does where solids that touch are in each
other by a little.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from braidx.output.arrays import Array
from braidx.output.figures.view import View

_CHUNK = 1_000_000  # pixels looked at together, roughly: some tens of MB of temporary arrays
_SEAM = (
    1e-9  # pixels, beyond round-off: triangles that share an edge leave no pinholes between them
)


@dataclass(frozen=True)
class Triangles:
    """Triangles with smooth normals; corners go round against the clock as seen from outside."""

    points: Array  # (n, 3), mm
    normals: Array  # (n, 3), unit, outward
    corners: NDArray[np.int64]  # (m, 3)
    colour: Array  # (m, 3), red, green, blue, 0..1
    inside: Array | None = None  # (m, 3), of cut faces by the triangle behind them; None: `colour`
    closed: bool = False  # whether the surface has no rims: its inner side is then never seen


@dataclass(frozen=True)
class Fragments:
    """What each pixel sees of triangles, arrays of the picture's shape (rows, columns)."""

    depth: Array  # mm towards the eye; -inf where the ray meets nothing
    triangle: NDArray[np.int64]  # -1 where the ray meets nothing
    is_cut: NDArray[np.bool_]
    normal: Array  # (rows, columns, 3), in the frame of the view
    colour: Array  # (rows, columns, 3), red, green, blue, 0..1

    @property
    def covered(self) -> NDArray[np.bool_]:
        """Where anything is seen."""
        return self.triangle >= 0


def joined(parts: Sequence[Triangles]) -> Triangles:
    """Several surfaces as one."""
    offsets = np.cumsum([0, *(len(part.points) for part in parts)])
    return Triangles(
        np.concatenate([part.points for part in parts]),
        np.concatenate([part.normals for part in parts]),
        np.concatenate([part.corners + offset for part, offset in zip(parts, offsets)]),
        np.concatenate([part.colour for part in parts]),
        np.concatenate([p.colour if p.inside is None else p.inside for p in parts]),
        all(part.closed for part in parts),
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
    pixels = (triangles.points - view.centre) @ view.axes.T
    pixels[:, 0] = (pixels[:, 0] + 0.5 * view.width) * view.pixels_per_mm - 0.5
    pixels[:, 1] = (pixels[:, 1] + 0.5 * view.height) * view.pixels_per_mm - 0.5
    corner = pixels[triangles.corners]  # (m, 3 corners, 3)
    edge_1, edge_2 = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    double_area = edge_1[:, 0] * edge_2[:, 1] - edge_1[:, 1] * edge_2[:, 0]
    cuts = bool(np.isfinite(view.cut_depth))
    hidden = double_area <= 0.0 if triangles.closed and not cuts else double_area == 0.0
    depth = np.full(rows * columns, -np.inf, dtype=np.float32)
    nearest = np.full(rows * columns, -1, dtype=np.int64)
    inside = _Inside(rows * columns)
    for who, row, first, count, z, slope in _spans(corner, double_area, hidden, (rows, columns)):
        span, column = ranges(np.arange(len(who)), first, count)
        depth_there = (z[span] + slope[span] * (column - first[span])).astype(np.float32)
        pixel, seen = (row * columns)[span] + column, who[span]
        if cuts:
            beyond = np.flatnonzero(depth_there <= view.cut_depth)
            pixel, seen, depth_there = pixel[beyond], seen[beyond], depth_there[beyond]
            inside.count(pixel, seen, depth_there, double_area[seen] < 0)
        front = np.flatnonzero(depth_there > depth[pixel])
        pixel, seen, depth_there = pixel[front], seen[front], depth_there[front]
        np.maximum.at(depth, pixel, depth_there)
        front = np.flatnonzero(depth_there == depth[pixel])
        nearest[pixel[front]] = seen[front]
    is_cut = inside.depth > 0
    nearest[is_cut] = inside.behind[is_cut]
    depth[is_cut] = view.cut_depth
    at = np.flatnonzero(nearest >= 0)
    who = nearest[at]
    normal, colour = np.zeros((2, rows * columns, 3), dtype=np.float32)
    normal[at] = _normals(triangles, view, corner, double_area, who, at % columns, at // columns)
    normal[is_cut] = (0.0, 0.0, 1.0)
    colour[at] = triangles.colour[who]
    if triangles.inside is not None:
        colour[is_cut] = triangles.inside[nearest[is_cut]]

    def picture(values: NDArray[Any]) -> NDArray[Any]:
        return values.reshape(rows, columns, *values.shape[1:])[::-1]

    # Single precision: no eye tells more, and pictures take half the memory traffic.
    return Fragments(
        picture(depth), picture(nearest), picture(is_cut), picture(normal), picture(colour)
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
        self._nearest = np.full(num_pixels, -np.inf, dtype=np.float32)

    def count(
        self,
        pixel: NDArray[np.int64],
        who: NDArray[np.int64],
        z: NDArray[np.float32],
        leaves: NDArray[np.bool_],
    ) -> None:
        """Takes in what rays meet beyond the plane: pixel, triangle, depth, and whether the ray leaves there."""
        np.add.at(self.depth, pixel, np.where(leaves, 1, -1))
        pixel, who, z = pixel[leaves], who[leaves], z[leaves]
        np.maximum.at(self._nearest, pixel, z)
        first = z == self._nearest[pixel]
        self.behind[pixel[first]] = who[first]


def _spans(
    corner: Array, double_area: Array, hidden: NDArray[np.bool_], shape: tuple[int, int]
) -> Iterator[
    tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64], NDArray[np.int64], Array, Array]
]:
    """Pixels that triangles cover, row by row, in portions of about _CHUNK pixels, nearest triangles first.

    Yields:
        Per span: triangle, row, first column, number of columns, depth there (mm) and its change per column (mm).
    """
    low, high = corner.min(axis=1), corner.max(axis=1)
    bottom = np.clip(np.ceil(low[:, 1]), 0, shape[0]).astype(np.int64)
    top = np.clip(np.floor(high[:, 1]) + 1, 0, shape[0]).astype(np.int64)
    off = hidden | (high[:, 0] < 0) | (low[:, 0] > shape[1] - 1) | (top <= bottom)
    order = np.flatnonzero(~off)
    order = order[np.argsort(-high[order, 2], kind="stable")]
    area = (top - bottom) * np.clip(high[:, 0] - low[:, 0] + 1.0, 1.0, shape[1])
    group = np.cumsum(area[order]).astype(np.int64) // _CHUNK
    for chunk in np.split(order, np.flatnonzero(np.diff(group)) + 1):
        who, row = ranges(chunk, bottom[chunk], (top - bottom)[chunk])
        left: Array = np.full(len(who), -np.inf)
        right: Array = np.full(len(who), np.inf)
        turn = np.sign(double_area[who])
        for a, b in ((0, 1), (1, 2), (2, 0)):
            start, edge = corner[who, a], corner[who, b] - corner[who, a]
            # Inside is where turn * (edge x (p - start)) >= 0, linear in the column.
            fall, rise = turn * edge[:, 1], turn * edge[:, 0] * (row - start[:, 1])
            with np.errstate(divide="ignore", invalid="ignore"):
                bound = start[:, 0] + rise / fall
            right = np.where(fall > 0, np.minimum(right, bound + _SEAM), right)
            left = np.where(fall < 0, np.maximum(left, bound - _SEAM), left)
            right = np.where((fall == 0) & (rise < 0), -np.inf, right)
        first = np.ceil(np.clip(left, 0, shape[1])).astype(np.int64)
        count = np.floor(np.clip(right, -1, shape[1] - 1)).astype(np.int64) - first + 1
        kept = np.flatnonzero(count > 0)
        who, row, first, count = who[kept], row[kept], first[kept], count[kept]
        start, edge_1, edge_2 = corner[who, 0], *(corner[who, k] - corner[who, 0] for k in (1, 2))
        slope_x = (edge_1[:, 2] * edge_2[:, 1] - edge_2[:, 2] * edge_1[:, 1]) / double_area[who]
        slope_y = (edge_2[:, 2] * edge_1[:, 0] - edge_1[:, 2] * edge_2[:, 0]) / double_area[who]
        z = start[:, 2] + slope_x * (first - start[:, 0]) + slope_y * (row - start[:, 1])
        yield who, row, first, count, z, slope_x


def _normals(
    triangles: Triangles,
    view: View,
    corner: Array,
    double_area: Array,
    who: NDArray[np.int64],
    column: NDArray[np.int64],
    row: NDArray[np.int64],
) -> Array:
    """Normals of pixels towards the eye, interpolated in the triangle seen, shape (n, 3), frame of the view."""
    normals = (triangles.normals @ view.axes.T)[triangles.corners] * np.sign(double_area)[
        :, None, None
    ]
    edge_1, edge_2 = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
    area = np.where(double_area == 0.0, 1.0, double_area)[:, None]
    to_1, to_2 = normals[:, 1] - normals[:, 0], normals[:, 2] - normals[:, 0]
    per_column = (to_1 * edge_2[:, 1:2] - to_2 * edge_1[:, 1:2]) / area
    per_row = (to_2 * edge_1[:, :1] - to_1 * edge_2[:, :1]) / area
    at_origin = normals[:, 0] - corner[:, 0, :1] * per_column - corner[:, 0, 1:2] * per_row
    x, y = column.astype(np.float32)[:, None], row.astype(np.float32)[:, None]
    single = [values.astype(np.float32) for values in (at_origin, per_column, per_row)]
    normal: Array = single[0][who] + x * single[1][who] + y * single[2][who]
    normal /= np.maximum(np.sqrt(np.einsum("ij,ij->i", normal, normal)), 1e-12)[:, None]
    return normal


def ranges(
    items: NDArray[np.int64], first: NDArray[np.int64], counts: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Each item repeated `counts` times, beside first, first + 1, ... of that item."""
    offset = np.cumsum(counts) - counts
    values = np.arange(counts.sum()) + np.repeat(first - offset, counts)
    return np.repeat(items, counts), values
