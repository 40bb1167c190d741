"""The axis of a rope, straight or bent, and places about it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree

from braidx.output.arrays import Array
from braidx.output.snapshot import Snapshot

_NEWTON_STEPS = 20
_X = np.array([1.0, 0.0, 0.0])


class RopeAxis:
    """A smooth curve about which yarns wind.

    Angles are counted from the x-axis about the tangent: the rope is bent across x, in the plane
    y-z, so that +90 degrees lies away from the sheave and -90 degrees at it.

    Args:
        line: Points in order, shape (n, 3) with n >= 4, mm.
    """

    def __init__(self, line: Array) -> None:
        self.line = np.asarray(line, dtype=float)
        self._curve = CubicSpline(np.arange(len(line)), self.line)
        self._slope, self._bend = self._curve.derivative(1), self._curve.derivative(2)
        self._tree = cKDTree(self.line)
        middles = 0.5 + np.arange(len(line) - 1)
        self._arc = np.concatenate([[0.0], np.cumsum(self._lengths(middles - 0.5, middles + 0.5))])

    def parameter(self, points: Array) -> Array:
        """Where the foot points of points lie, as index of the axis's points, real, shape (k,)."""
        u = self._tree.query(points)[1].astype(float)
        for _ in range(_NEWTON_STEPS):
            away, slope = points - self._curve(u), self._slope(u)
            square = _dot(slope, slope)
            # Nearer the axis than its centre of curvature this is positive.
            curved = np.maximum(square - _dot(away, self._bend(u)), 0.2 * square)
            step = np.clip(_dot(away, slope) / curved, -1.0, 1.0)
            u = u + step
            if not len(u) or np.abs(step).max() < 1e-13:
                break
        return u

    def at(self, parameter: Array) -> tuple[Array, Array]:
        """Points of the axis and its unit tangents, both of shape (k, 3)."""
        slope = self._slope(parameter)
        return self._curve(parameter), slope / np.linalg.norm(slope, axis=1, keepdims=True)

    def arc_length(self, parameter: Array) -> Array:
        """Length of the axis from its first point, mm."""
        piece = np.clip(np.floor(parameter).astype(int), 0, len(self.line) - 2)
        return self._arc[piece] + self._lengths(piece.astype(float), parameter)

    def unroll(self, points: Array) -> tuple[Array, Array, Array]:
        """Places about the axis.

        Returns:
            Length along the axis, mm, angle in (-pi, pi], rad, and distance from the axis, mm.
        """
        u = self.parameter(points)
        foot, tangent = self.at(u)
        side = _X - (tangent @ _X)[:, None] * tangent
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        away = points - foot
        x, y = _dot(away, side), _dot(away, np.cross(tangent, side))
        return self.arc_length(u), np.arctan2(y, x), np.hypot(x, y)

    def straightened(self, points: Array) -> Array:
        """The points as they would lie about the z-axis, shape (k, 3)."""
        z, angle, distance = self.unroll(points)
        return np.stack([distance * np.cos(angle), distance * np.sin(angle), z], axis=1)

    def _lengths(self, start: Array, end: Array) -> Array:
        half = 0.5 * (end - start)
        speeds = [
            np.linalg.norm(self._slope(start + half * (1 + point)), axis=1)
            for point in (-np.sqrt(0.6), 0.0, np.sqrt(0.6))
        ]
        return np.asarray(half * (np.array([5.0, 8.0, 5.0]) / 9.0 @ speeds))


def mean_axis(lines: Sequence[Array]) -> RopeAxis:
    """The mean of all yarns as the axis of a braid, whose yarns lie evenly about it.

    Args:
        lines: Per yarn the nodes, shape (n_i, 3), mm, spread alike over its length.
    """
    count = max(len(line) for line in lines)
    total = np.zeros((count, 3))
    for line in lines:
        if len(line) == count:
            total += line
        else:
            place = np.linspace(0.0, len(line) - 1.0, count)
            known = np.arange(len(line))
            total += np.stack([np.interp(place, known, channel) for channel in line.T], axis=1)
    return RopeAxis(total / len(lines))


def axis_of(snapshot: Snapshot) -> RopeAxis:
    """The axis of a rope: that of its core, or else the mean of its yarns."""
    if snapshot.core is not None and len(snapshot.core.line) >= 4:
        return RopeAxis(snapshot.core.line)
    return mean_axis(snapshot.centre_lines)


def _dot(u: Array, v: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", u, v))
