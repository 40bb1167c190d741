"""Round tubes as closed surfaces: smooth where a chain of cylinders would show its joints."""

from __future__ import annotations

import numpy as np

from braidx.output.arrays import Array
from braidx.output.cuts import node_tangents
from braidx.output.figures.triangles import Triangles

_SIDES = 20
_STEP = 0.5  # of the radius: length of a piece, roughly
_MOST_PIECES = 6  # per segment


def swept(line: Array, radius: float, colour: Array) -> Triangles:
    """A tube along a smoothed line, closed at its ends.

    Args:
        line: Nodes, shape (n, 3), mm.
        radius: mm.
        colour: One colour, shape (1, 3), or one per segment, shape (n - 1, 3), which then changes
            smoothly from segment to segment.
    """
    spacing = float(np.linalg.norm(np.diff(line, axis=0), axis=1).mean())
    pieces = int(np.clip(np.ceil(spacing / (_STEP * radius)), 1, _MOST_PIECES))
    smooth = hermite(line, pieces)
    tangent = node_tangents(smooth)
    first = _carried(tangent)
    angle = np.linspace(0.0, 2 * np.pi, _SIDES, endpoint=False)
    outward = (
        np.cos(angle)[:, None] * first[:, None]
        + np.sin(angle)[:, None] * np.cross(tangent, first)[:, None]
    )
    points = (smooth[:, None] + radius * outward).reshape(-1, 3)
    a = (_SIDES * np.arange(len(smooth) - 1)[:, None] + np.arange(_SIDES)).ravel()
    b = a - np.arange(_SIDES * (len(smooth) - 1)) % _SIDES + (np.arange(len(a)) + 1) % _SIDES
    c, d = a + _SIDES, b + _SIDES
    corners = [np.stack([a, b, d], axis=1), np.stack([a, d, c], axis=1)]
    place = np.linspace(0.5 / pieces, len(line) - 1 - 0.5 / pieces, len(smooth) - 1)
    known = 0.5 + np.arange(len(colour))
    along = np.stack([np.interp(place, known, channel) for channel in colour.T], axis=1)
    tint = along.repeat(_SIDES, axis=0)
    # End faces with points of their own, so that their rims stay sharp.
    ends = np.concatenate([points[:_SIDES], points[-_SIDES:], smooth[:1], smooth[-1:]])
    lids = np.repeat([-tangent[0], tangent[-1]], _SIDES, axis=0)
    first_lid = len(points) + np.arange(_SIDES)
    middle = len(points) + 2 * _SIDES
    lid = np.stack([np.roll(first_lid, -1), first_lid, np.full(_SIDES, middle)], axis=1)
    other = np.stack([first_lid, np.roll(first_lid, -1), np.full(_SIDES, middle)], axis=1)
    other += [_SIDES, _SIDES, 1]
    return Triangles(
        np.concatenate([points, ends]),
        np.concatenate([outward.reshape(-1, 3), lids, [-tangent[0], tangent[-1]]]),
        np.concatenate([*corners, lid, other]),
        np.concatenate([tint, tint, along[:1].repeat(_SIDES, 0), along[-1:].repeat(_SIDES, 0)]),
        closed=True,
    )


def hermite(line: Array, pieces: int) -> Array:
    """Cubic through the nodes of a line, `pieces` stretches per segment."""
    chord = np.linalg.norm(np.diff(line, axis=0), axis=1)[:, None]
    tangent = node_tangents(line)
    parts = []
    for s in np.arange(pieces) / pieces:
        parts.append(
            (1 + 2 * s) * (1 - s) ** 2 * line[:-1]
            + s * (1 - s) ** 2 * chord * tangent[:-1]
            + s**2 * (3 - 2 * s) * line[1:]
            - s**2 * (1 - s) * chord * tangent[1:]
        )
    return np.concatenate([np.stack(parts, axis=1).reshape(-1, 3), line[-1:]])


def _carried(tangent: Array) -> Array:
    """A unit vector across each tangent of a line, turned as little as possible from one to the next."""
    current = np.eye(3)[np.argmin(np.abs(tangent[0]))]
    result = np.empty_like(tangent)
    for node, along in enumerate(tangent):
        current = current - (current @ along) * along
        current /= np.sqrt(current @ current)
        result[node] = current
    return result
