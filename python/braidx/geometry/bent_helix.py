"""Closed forms of a braid bent over a sheave. Angles in radians from the rope's axis, lengths in mm."""

from __future__ import annotations

import math


def bend_radius(sheave_diameter: float, rope_diameter: float) -> float:
    """Radius of the rope's axis round a sheave whose diameter is that where the rope lies."""
    return (sheave_diameter + rope_diameter) / 2.0


def frictionless_slip(radius: float, angle: float, bend_radius: float) -> float:
    """Largest relative displacement of crossing yarns of a bent braid without friction.

    Bent, a helix is stretched by radius / bend_radius cos(turn) cos(angle)^2 at the turn from the outermost point.
    Free to slide it evens this out: it moves along itself by up to radius^2 cos(angle)^2 / (bend_radius sin(angle)),
    most where it lies beside the axis, and yarns of the other direction by as much the other way. What is left of the
    two, along the axis, is 2 radius^2 cos(angle)^3 / (bend_radius sin(angle)): an upper estimate of the trend.

    Args:
        radius: Distance of the yarns from the rope's axis.
        angle: Braid angle from the axis, above 0.
        bend_radius: Radius that the rope's axis is bent to.
    """
    return 2.0 * radius**2 * math.cos(angle) ** 3 / (bend_radius * math.sin(angle))
