"""Centre lines of rods."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


def straight(start: Sequence[float], end: Sequence[float], num_spans: int) -> Floats:
    """Nodes of a straight line, shape (num_spans + 1, 3), mm."""
    return np.asarray(np.linspace(start, end, num_spans + 1), dtype=np.float64)


def curve(point: Callable[[Floats], Floats], begin: float, end: float, num_spans: int) -> Floats:
    """Nodes of any curve, equally far from each other along it.

    Args:
        point: Positions, shape (n, 3), mm, of parameters, shape (n,).
        begin, end: Parameters of its ends.
    Returns:
        Shape (num_spans + 1, 3), mm.
    """
    fine: Floats = np.asarray(np.linspace(begin, end, 50 * num_spans + 1), dtype=np.float64)
    length = np.append(0.0, np.linalg.norm(np.diff(point(fine), axis=0), axis=1).cumsum())
    places = np.interp(np.linspace(0.0, length[-1], num_spans + 1), length, fine)
    return point(np.asarray(places, dtype=np.float64))


def arc(radius: float, angle: float, num_spans: int) -> Floats:
    """Nodes of an arc that starts at the origin along x and bends towards y; shape (num_spans + 1, 3), mm.

    Args:
        angle: By which its tangent turns, radians.
    """
    turn = np.linspace(0.0, angle, num_spans + 1)
    return radius * np.stack([np.sin(turn), 1.0 - np.cos(turn), 0.0 * turn], axis=1)


def ring(radius: float, num_spans: int, overlap: float = 0.0) -> Floats:
    """Nodes of a ring about the z axis; first and last coincide unless they overlap by an angle (radians)."""
    angle = np.linspace(0.0, 2.0 * np.pi + overlap, num_spans + 1)
    return radius * np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)


def helix(
    radius: float, pitch: float, length: float, num_spans: int, phase: float = 0.0, degree: int = 1
) -> Floats:
    """Nodes of a helix about the z axis, from z = 0 to `length`, shape (num_spans + 1, 3), mm.

    Args:
        radius: That no point of the rod comes nearer to the axis than; nodes of elements of degree 2 lie a little
            outside, so that a rod placed about a core does not penetrate it between its nodes.
        pitch: Height of a turn, negative for one to the left, mm.
        phase: Angle at z = 0, radians.
        degree: Of the elements that the nodes are for.
    """
    if degree == 2:
        # With the angle h between nodes, the parabola through three of them comes as near as r sqrt(1 - c^2 / 4).
        c = 1.0 - np.cos(2.0 * np.pi * length / (pitch * num_spans))
        radius = radius / np.sqrt(1.0 - 0.25 * c**2)
    z = np.linspace(0.0, length, num_spans + 1)
    angle = phase + 2.0 * np.pi * z / pitch
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
