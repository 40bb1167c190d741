"""Where two yarns of different directions cross: one lies above the other as seen from the axis.

The distance between two yarns is no measure of a crossing in a tight braid: where each wraps about
the other it has a saddle there, with minima on either side. Seen along a radius of the rope the two
yarns cross at a definite angle, straight or bent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from braidx.output.arrays import Array, Integers
from braidx.output.rope_axis import RopeAxis, mean_axis
from braidx.output.yarn_curves import YarnCurves

REACH = 1.3  # of the sum of two radii: yarns farther apart only pass each other
_SAME = 0.05  # node spacings: nearer crossings of two yarns are one and the same
_STEPS = 60


@dataclass(frozen=True)
class InterlacingPoints:
    """The interlacing points of a rope (k of them), in one state."""

    yarn_a: Integers  # (k,), of layer 0
    yarn_b: Integers  # (k,), of layer 1
    s_a: Array  # (k,), node index on yarn a, real
    s_b: Array  # (k,), node index on yarn b, real
    position: Array  # (k, 3), mm, half way between the two yarns
    distance: Array  # (k,), mm, between the centre lines

    def __len__(self) -> int:
        return len(self.s_a)

    def chosen(self, which: Integers) -> InterlacingPoints:
        """Some of the points, in the order given."""
        return InterlacingPoints(**{f.name: getattr(self, f.name)[which] for f in fields(self)})


def find_interlacing(
    lines: Sequence[Array],
    radius: Array,
    layer: Integers,
    axis: RopeAxis | None = None,
    reach: float = REACH,
) -> InterlacingPoints:
    """All interlacing points, ordered by yarn a, yarn b and s_a.

    Args:
        lines: Per yarn the nodes of the centre line, shape (n_i, 3), mm.
        radius: Per yarn, mm.
        layer: Per yarn its direction, 0 or 1; only yarns of different directions cross.
        axis: Axis of the rope; the mean of the yarns if None.
        reach: Largest distance at a crossing, in sums of the two radii.
    Source: paper 2, "Relative displacement": two nodes of crossing yarns at one interlacing point.
    """
    curves, axis = YarnCurves(lines), axis or mean_axis(lines)
    unrolled = [np.stack(axis.unroll(line), axis=1) for line in lines]
    starts = [
        _close_nodes(a, b, unrolled)
        for a in np.flatnonzero(layer == 0)
        for b in np.flatnonzero(layer == 1)
    ]
    yarn_a, yarn_b, s_a, s_b = np.concatenate([np.empty((0, 4)), *starts]).T
    a, b = yarn_a.astype(np.int64), yarn_b.astype(np.int64)
    s_a, s_b, found = crossing(curves, axis, a, b, s_a, s_b)
    position_a, position_b = curves(a, s_a), curves(b, s_b)
    distance = np.linalg.norm(position_b - position_a, axis=1)
    kept = np.flatnonzero(found & (distance < reach * (radius[a] + radius[b])))
    points = InterlacingPoints(a, b, s_a, s_b, 0.5 * (position_a + position_b), distance)
    return _distinct(points.chosen(kept))


def crossing(
    curves: YarnCurves, axis: RopeAxis, yarn_a: Integers, yarn_b: Integers, s_a: Array, s_b: Array
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Where two yarns lie on one radius of the rope, near given material points.

    Newton's method on two conditions: the separation has no part along the axis, and the two
    positions, seen from the foot point on the axis, are parallel. The foot point follows.

    Returns:
        s_a and s_b, shape (k,), and whether a crossing was found between the ends of the yarns.
    """
    s = np.stack([s_a, s_b], axis=1).astype(float)
    step = np.full(s.shape, np.inf)
    for _ in range(_STEPS):
        x_a, x_b = curves(yarn_a, s[:, 0]), curves(yarn_b, s[:, 1])
        foot, along = axis.at(axis.parameter(0.5 * (x_a + x_b)))
        from_a, from_b = x_a - foot, x_b - foot
        d_a, d_b = curves(yarn_a, s[:, 0], 1), curves(yarn_b, s[:, 1], 1)
        turn, apart = _turn(from_a, from_b, along), _dot(x_b - x_a, along)
        turn_a, turn_b = _turn(d_a, from_b, along), _turn(from_a, d_b, along)
        apart_a, apart_b = -_dot(d_a, along), _dot(d_b, along)
        area = turn_a * apart_b - turn_b * apart_a
        area = np.where(np.abs(area) < 1e-12, 1e-12, area)
        step = np.stack([turn_b * apart - apart_b * turn, apart_a * turn - turn_a * apart], axis=1)
        step = np.clip(step / area[:, None], -1.0, 1.0)
        s += step
        if not len(s) or np.abs(step).max() < 1e-12:
            break
    inside = (s >= -1e-9).all(axis=1) & (s[:, 0] <= curves.last[yarn_a] + 1e-9)
    inside &= s[:, 1] <= curves.last[yarn_b] + 1e-9
    return s[:, 0], s[:, 1], inside & (np.abs(step).max(axis=1) < 1e-8)


def radial(axis: RopeAxis, points: Array) -> Array:
    """Unit vectors away from the axis, shape (k, 3)."""
    foot, _ = axis.at(axis.parameter(points))
    away = points - foot
    return np.asarray(away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-300))


def _close_nodes(a: int, b: int, unrolled: Sequence[Array]) -> Array:
    """Pairs of nodes of two yarns nearest to each other in the unrolled rope.

    Returns:
        Rows yarn, yarn, node, node of all minima nearer than two node spacings.
    """
    (z_a, angle_a, r_a), (z_b, angle_b, r_b) = unrolled[a].T, unrolled[b].T
    turn = np.remainder(angle_b - angle_a[:, None] + np.pi, 2 * np.pi) - np.pi
    # Both yarns on one cylinder, so that they do cross there.
    square = (0.5 * (r_a[:, None] + r_b) * turn) ** 2 + (z_b - z_a[:, None]) ** 2
    padded = np.pad(square, 1, constant_values=np.inf)
    rows, columns = square.shape
    around = [
        padded[1 + i : 1 + i + rows, 1 + j : 1 + j + columns]
        for i in (-1, 0, 1)
        for j in (-1, 0, 1)
        if i or j
    ]
    spacing = max(np.abs(np.diff(z)).max() + r.max() * 0.3 for z, r in ((z_a, r_a), (z_b, r_b)))
    i, j = np.nonzero((square <= np.minimum.reduce(around)) & (square < (2 * spacing) ** 2))
    return np.stack([np.full(len(i), a), np.full(len(i), b), i, j], axis=1).astype(float)


def _distinct(points: InterlacingPoints) -> InterlacingPoints:
    """Sorted, and without repetitions."""
    order = np.lexsort((points.s_b, points.s_a, points.yarn_b, points.yarn_a))
    points = points.chosen(order)
    repeats = (
        (np.diff(points.yarn_a) == 0)
        & (np.diff(points.yarn_b) == 0)
        & (np.abs(np.diff(points.s_a)) < _SAME)
        & (np.abs(np.diff(points.s_b)) < _SAME)
    )
    return points.chosen(np.flatnonzero(np.concatenate([[True], ~repeats])[: len(points)]))


def _turn(u: Array, v: Array, along: Array) -> Array:
    """Part of u x v along the axis."""
    return _dot(np.asarray(np.cross(u, v)), along)


def _dot(u: Array, v: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", u, v))
