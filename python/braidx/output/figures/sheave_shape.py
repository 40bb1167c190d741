"""The sheave as a closed surface to be drawn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from braidx.output.figures.triangles import Triangles, joined, smooth_normals
from braidx.output.sheave_picture import SheavePicture
from braidx.output.snapshot import Array

_AROUND = 240  # faces round the axis
_COLOUR, _MARK = (0.74, 0.76, 0.79), (0.45, 0.48, 0.53)
_HUB = 0.25  # of the radius


def half_width(sheave: SheavePicture, rope_radius: float) -> float:
    """Half the width that is drawn of a sheave, mm: a cylinder has no ends of its own."""
    if sheave.groove_radius is None:
        return 1.6 * rope_radius
    return 0.97 * sheave.groove_radius


def sheave_surface(sheave: SheavePicture, rope_radius: float) -> Triangles:
    """Rim, sides and bore; a darker mark at the bore and the side shows how far it has turned.

    Args:
        sheave: The sheave.
        rope_radius: Half the diameter of the rope, mm; a flat sheave is drawn wide enough for it.
    """
    half = half_width(sheave, rope_radius)
    across: Array = np.linspace(-half, half, 33, dtype=np.float64)
    rim = np.stack([across, sheave.profile(across)], axis=1)
    hub = _HUB * sheave.radius
    side = np.linspace(hub, rim[0, 1], 12)
    bore = np.array([[half, hub], [-half, hub]])
    pieces = [
        np.stack([np.full(12, -half), side], axis=1),
        rim,
        np.stack([np.full(12, half), side[::-1]], axis=1),
        bore,
    ]
    # Each with points of its own, so that edges between them stay sharp.
    surfaces = [_revolved(sheave, piece) for piece in pieces]
    return replace(joined(surfaces), closed=True)


def _revolved(sheave: SheavePicture, profile: Array) -> Triangles:
    """A profile (distance from the middle plane, radius) turned about the axis."""
    axis = sheave.axis / np.linalg.norm(sheave.axis)
    first = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    first /= np.linalg.norm(first)
    second = np.cross(axis, first)
    angle = np.linspace(0.0, 2 * np.pi, _AROUND, endpoint=False) + sheave.angle
    ring = np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second
    points = (
        sheave.centre
        + profile[:, None, :1] * axis
        + profile[:, None, 1:] * ring[None]  # (profile, around, 3)
    )
    row, column = np.meshgrid(np.arange(len(profile) - 1), np.arange(_AROUND), indexing="ij")
    beside = (column + 1) % _AROUND
    a, b = row * _AROUND + column, row * _AROUND + beside
    c, d = a + _AROUND, b + _AROUND
    corners = np.concatenate(
        [np.stack([a, b, c], axis=-1).reshape(-1, 3), np.stack([b, d, c], axis=-1).reshape(-1, 3)]
    )
    flat = points.reshape(-1, 3)
    marked = np.tile((column < 4).ravel(), 2)
    colour = np.where(marked[:, None], _MARK, _COLOUR)
    return Triangles(flat, smooth_normals(flat, corners), corners, colour)
