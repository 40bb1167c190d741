"""Centre lines of rods."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from ..geometry.helix import MOST_TURN, outside

Floats = npt.NDArray[np.float64]
ROUND_OFF = 1e-9  # relative


def straight(start: Sequence[float], end: Sequence[float], num_spans: int) -> Floats:
    """Nodes of a straight line, shape (num_spans + 1, 3), mm."""
    return np.asarray(np.linspace(start, end, num_spans + 1), dtype=np.float64)


def graded(
    start: Sequence[float], end: Sequence[float], num_spans: int, ratio: float, degree: int = 2
) -> Floats:
    """Nodes of a straight line whose elements grow by equal factors, shape (num_spans + 1, 3), mm.

    Args:
        ratio: Length of the last element over that of the first.
        degree: Of the elements, which take as many spans of equal length.
    Raises:
        ValueError: If the ratio is not positive, or spans do not make whole elements.
    """
    if not (np.isfinite(ratio) and ratio > 0.0):
        raise ValueError(f"ratio is {ratio}: give a positive one, 1 for equal elements")
    if num_spans < 1 or num_spans % degree:
        raise ValueError(
            f"num_spans is {num_spans}: elements of degree {degree} take {degree} each"
        )
    elements = np.geomspace(1.0, ratio, num_spans // degree)
    places = np.append(0.0, np.cumsum(elements.repeat(degree)))
    a, b = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    return np.asarray(a + (places / places[-1])[:, None] * (b - a))


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


def helix(radius: float, pitch: float, length: float, num_spans: int, phase: float = 0.0) -> Floats:
    """Nodes of a helix about the z axis, from z = 0 to `length`, shape (num_spans + 1, 3), mm.

    Args:
        radius: That no point of the rod comes nearer to the axis than, whatever the degree of its elements: nodes lie a
            little outside (0.07 % with 16 spans in a turn, a sixteenth of that with 32). A rod placed about a core thus
            does not penetrate it between nodes.
        pitch: Height of a turn, negative for one to the left, mm.
        phase: Angle at z = 0, radians.
    Raises:
        ValueError: If a turn has less than four spans.
    """
    turn = 2.0 * np.pi * length / (pitch * num_spans)
    if abs(turn) > MOST_TURN * (1.0 + ROUND_OFF):
        least = math.ceil(4.0 * abs(length / pitch) - ROUND_OFF)
        raise ValueError(
            f"num_spans = {num_spans}: a helix needs four spans in a turn, here {least}"
        )
    radius = outside(radius, turn)
    z = np.linspace(0.0, length, num_spans + 1)
    angle = phase + turn * np.arange(num_spans + 1)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
