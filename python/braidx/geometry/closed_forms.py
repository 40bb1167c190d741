"""Closed-form measures of biaxial braids. Angles in radians from the rope's axis, lengths in mm."""

from __future__ import annotations

import math


def helix_angle(radius: float, pitch: float) -> float:
    """Angle of a helix from its axis: tan(angle) = 2 pi radius / pitch (paper 1, 5.2.3)."""
    return math.atan(2.0 * math.pi * radius / pitch)


def braid_pitch(radius: float, angle: float) -> float:
    """Pitch of a helix of this angle, mm; the inverse of `helix_angle`."""
    return 2.0 * math.pi * radius / math.tan(angle)


def line_cover(count: int, width: float, radius: float, angle: float) -> float:
    """Share of the cylinder that the strands of one direction cover, above 1 where they overlap.

    Args:
        count: Strands of both directions together.
        width: Width of a strand, mm.
        radius: Mean radius of the braid, mm.
        angle: Braid angle.
    """
    return count * width / (4.0 * math.pi * radius * math.cos(angle))


def cover_factor(count: int, width: float, radius: float, angle: float) -> float:
    """Share of the cylinder covered by a biaxial braid; arguments as for `line_cover`."""
    return 1.0 - (1.0 - min(1.0, line_cover(count, width, radius, angle))) ** 2


def jamming_angle(count: int, width: float, radius: float) -> float | None:
    """Angle at which neighbours of one direction touch; None where they overlap at any angle."""
    cosine = count * width / (4.0 * math.pi * radius)
    return math.acos(cosine) if cosine <= 1.0 else None


def strand_share(per_direction: int, radius: float, pitch: float) -> float:
    """Width each strand of one direction has to itself, across the strand, mm."""
    return 2.0 * math.pi * radius / per_direction * math.cos(helix_angle(radius, pitch))
