"""Pictures of tubes by casting one ray per pixel: NumPy only, no display, no graphics driver.

A tube is a chain of round cylinders. In the frame of the view (x right, y up, z towards the eye)
the ray of a pixel meets a cylinder where a quadratic in z vanishes; the nearest hit wins. A cutting
plane z = const shows the inside: where it lies between entry and exit, the cut face is drawn.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from braidx.output.snapshot import Array

_CHUNK = 1_000_000  # pixels looked at together, roughly
_OVERLAP = 0.05  # of the radius: hides the wedge between two cylinders of a bent tube


@dataclass(frozen=True)
class View:
    """Parallel projection of a box of space onto pixels."""

    right: Array  # (3,), unit
    up: Array  # (3,), unit, across right
    centre: Array  # (3,), mm, in the middle of the picture
    width: float  # mm
    height: float  # mm
    pixels_per_mm: float
    cut_depth: float = np.inf  # mm towards the eye from `centre`; what lies nearer is cut away

    @property
    def axes(self) -> Array:
        """Rows right, up, towards the eye, shape (3, 3)."""
        return np.stack([self.right, self.up, np.cross(self.right, self.up)])

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the picture."""
        rows = max(int(round(self.height * self.pixels_per_mm)), 1)
        return rows, max(int(round(self.width * self.pixels_per_mm)), 1)

    def finer(self, times: int) -> View:
        """The same view with so many pixels for one in either direction."""
        rows, columns = self.shape
        return View(
            self.right,
            self.up,
            self.centre,
            columns / self.pixels_per_mm,
            rows / self.pixels_per_mm,
            self.pixels_per_mm * times,
            self.cut_depth,
        )


@dataclass(frozen=True)
class Tubes:
    """Chains of cylinders, one row per cylinder (m)."""

    start: Array  # (m, 3), mm
    end: Array  # (m, 3), mm
    start_tangent: Array  # (m, 3), unit tangents of the smooth curve at the ends
    end_tangent: Array  # (m, 3)
    radius: Array  # (m,), mm
    colour: Array  # (m, 3), red, green, blue, 0..1


@dataclass(frozen=True)
class Hits:
    """What each pixel sees, arrays of the picture's shape (rows, columns)."""

    depth: Array  # mm towards the eye; -inf where the ray meets nothing
    cylinder: NDArray[np.int64]  # -1 where the ray meets nothing
    is_cut: NDArray[np.bool_]
    normal: Array  # (rows, columns, 3), in the frame of the view


def cast(tubes: Tubes, view: View) -> Hits:
    """Cast a ray per pixel; the first row of the picture is the top one."""
    rows, columns = view.shape
    start = (tubes.start - view.centre) @ view.axes.T
    end = (tubes.end - view.centre) @ view.axes.T
    corner = np.array([-0.5 * view.width, -0.5 * view.height])
    depth = np.full(rows * columns, -np.inf)
    cylinder = np.full(rows * columns, -1, dtype=np.int64)
    kind = np.zeros(rows * columns, dtype=np.int8)
    for who, column in _columns(start, end, tubes.radius, view):
        who, column, row = _rows(start, end, tubes.radius, view, who, column)
        # Nearest cylinders come first: most pixels of the others are hidden already.
        pixel = row * columns + column
        highest = np.maximum(start[:, 2], end[:, 2]) + tubes.radius
        open_ = np.flatnonzero(depth[pixel] < np.minimum(highest, view.cut_depth)[who])
        who, pixel = who[open_], pixel[open_]
        x = corner[0] + (column[open_] + 0.5) / view.pixels_per_mm
        y = corner[1] + (row[open_] + 0.5) / view.pixels_per_mm
        z, what = _meet(x, y, start[who], end[who], tubes.radius[who], view.cut_depth)
        met = np.flatnonzero(what)
        pixel, z, who, what = pixel[met], z[met], who[met], what[met]
        np.maximum.at(depth, pixel, z)
        nearest = z == depth[pixel]
        cylinder[pixel[nearest]] = who[nearest]
        kind[pixel[nearest]] = what[nearest]
    normal = _normals(tubes, view, depth, cylinder, kind, start, end)

    def picture(values: NDArray[Any]) -> NDArray[Any]:
        return values.reshape(rows, columns, *values.shape[1:])[::-1]

    return Hits(picture(depth), picture(cylinder), picture(kind == 3), picture(normal))


def _columns(
    start: Array, end: Array, radius: Array, view: View
) -> Iterator[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """Columns of pixels that each cylinder may cover, in portions, nearest cylinders first.

    Yields:
        Cylinder and column of the portion, both of shape (n,).
    """
    axis = end - start
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    reach = radius * (np.sqrt(np.maximum(1 - axis[:, 0] ** 2, 0.0)) + _OVERLAP)
    middle = 0.5 * view.width
    low = (np.minimum(start[:, 0], end[:, 0]) - reach + middle) * view.pixels_per_mm
    high = (np.maximum(start[:, 0], end[:, 0]) + reach + middle) * view.pixels_per_mm
    first = np.clip(np.floor(low), 0, view.shape[1]).astype(np.int64)
    counts = np.clip(np.ceil(high), 0, view.shape[1]).astype(np.int64) - first
    order = np.argsort(-np.maximum(start[:, 2], end[:, 2]) - radius)
    order = order[counts[order] > 0]
    tall = 2 * radius[order] * view.pixels_per_mm
    group = np.cumsum(counts[order] * tall).astype(np.int64) // _CHUNK
    for number in np.unique(group):
        chunk = order[group == number]
        yield ranges(chunk, first[chunk], counts[chunk])


def _rows(
    start: Array,
    end: Array,
    radius: Array,
    view: View,
    who: NDArray[np.int64],
    column: NDArray[np.int64],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Pixels of given columns that lie in the box of their cylinder and in the strip about it.

    Returns:
        Cylinder, column and row of each pixel, all of shape (n,).
    """
    axis = end - start
    direction = axis / np.linalg.norm(axis, axis=1, keepdims=True)
    reach = radius * (np.sqrt(np.maximum(1 - direction[:, 1] ** 2, 0.0)) + _OVERLAP)
    low = (np.minimum(start[:, 1], end[:, 1]) - reach)[who]
    high = (np.maximum(start[:, 1], end[:, 1]) + reach)[who]
    x = (column + 0.5) / view.pixels_per_mm - 0.5 * view.width
    flat = np.abs(axis[:, 0]) > 1e-6 * np.abs(axis).max(axis=1)
    run = np.where(flat, axis[:, 0], 1.0)
    slope = np.where(flat, axis[:, 1] / run, 0.0)
    spread = np.where(flat, radius * np.sqrt(1.0 + slope**2), np.inf)
    line = start[who, 1] + slope[who] * (x - start[who, 0])
    low = np.maximum(low, line - spread[who])
    high = np.minimum(high, line + spread[who])
    scale, middle, rows = view.pixels_per_mm, 0.5 * view.height, view.shape[0]
    first = np.clip(np.floor((low + middle) * scale), 0, rows).astype(np.int64)
    counts = np.clip(np.ceil((high + middle) * scale), 0, rows).astype(np.int64) - first
    counts = np.maximum(counts, 0)
    pair, row = ranges(np.arange(len(who)), first, counts)
    return who[pair], column[pair], row


def ranges(
    items: NDArray[np.int64], first: NDArray[np.int64], counts: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Each item repeated `counts` times, beside first, first + 1, ... of that item."""
    offset = np.cumsum(counts) - counts
    values = np.arange(counts.sum()) + np.repeat(first - offset, counts)
    return np.repeat(items, counts), values


def _meet(
    x: Array, y: Array, start: Array, end: Array, radius: Array, cut_depth: float
) -> tuple[Array, NDArray[np.int8]]:
    """Depth at which rays (x, y) meet finite cylinders.

    Returns:
        Depth, and what is met there: 0 nothing, 1 the side, 2 an end face, 3 the cutting plane.
    """
    axis = end - start
    length = np.sqrt(np.einsum("ij,ij->i", axis, axis))
    dx, dy, dz = (axis / length[:, None]).T
    wx, wy = x - start[:, 0], y - start[:, 1]
    along = wx * dx + wy * dy
    across = np.maximum(1.0 - dz * dz, 1e-12)
    root = (along * dz) ** 2 - across * (wx * wx + wy * wy - along**2 - radius**2)
    hit = root >= 0.0
    root = np.sqrt(np.where(hit, root, 0.0))
    top = (along * dz + root) / across
    bottom = (along * dz - root) / across
    # The stretch of the ray between the two end planes.
    margin = _OVERLAP * radius
    steep = np.where(np.abs(dz) < 1e-9, 1e-9, dz)
    face_a, face_b = (-margin - along) / steep, (length + margin - along) / steep
    near, far = np.maximum(face_a, face_b), np.minimum(face_a, face_b)
    what = np.where(top <= near, 1, 2).astype(np.int8)
    entry, leave = np.minimum(top, near), np.maximum(bottom, far)
    plane = cut_depth - start[:, 2]
    what[entry > plane] = 3
    entry = np.minimum(entry, plane)
    what[~hit | (entry < leave)] = 0
    return entry + start[:, 2], what


def _normals(
    tubes: Tubes,
    view: View,
    depth: Array,
    cylinder: NDArray[np.int64],
    kind: NDArray[np.int8],
    start: Array,
    end: Array,
) -> Array:
    """Outward normals at the hits, of the smooth tube rather than of the single cylinders."""
    axes, (_, columns) = view.axes, view.shape
    normal = np.zeros((len(depth), 3))
    at = np.flatnonzero(cylinder >= 0)
    who = cylinder[at]
    point = np.stack(
        [
            (at % columns + 0.5) / view.pixels_per_mm - 0.5 * view.width,
            (at // columns + 0.5) / view.pixels_per_mm - 0.5 * view.height,
            depth[at],
        ],
        axis=1,
    )
    axis = end[who] - start[who]
    from_start = point - start[who]
    share = np.einsum("ij,ij->i", from_start, axis) / np.einsum("ij,ij->i", axis, axis)
    share = np.clip(share, 0.0, 1.0)[:, None]
    tangent = ((1 - share) * tubes.start_tangent[who] + share * tubes.end_tangent[who]) @ axes.T
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    outward = from_start - share * axis
    outward -= np.einsum("ij,ij->i", outward, tangent)[:, None] * tangent
    # An end face; its rim is rounded off, which also hides the steps between cylinders of a bend.
    inner = np.linalg.norm(outward, axis=1) < 0.9 * tubes.radius[who]
    face = (kind[at] == 2) & inner
    outward[face] = np.sign(tangent[face, 2:]) * tangent[face]
    outward[kind[at] == 3] = (0.0, 0.0, 1.0)
    normal[at] = outward / np.maximum(np.linalg.norm(outward, axis=1, keepdims=True), 1e-12)
    return normal
