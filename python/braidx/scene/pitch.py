"""The pitch of a rope, given as such or by the angle of its braid."""

from __future__ import annotations

import math

from braidx.scene.errors import SceneError
from braidx.scene.recipe import BraidRecipe, RopeRecipe

AGREE = 1e-9  # relative difference up to which pitch and angle say the same


def resolved_pitch(rope: RopeRecipe, braid: BraidRecipe | None) -> float:
    """Pitch of a rope, mm: rope.pitch, or 2 pi R tan(angle), the angle being that from the plane across the axis.

    Raises:
        SceneError: If neither or both are given and both do not agree.
    """
    if braid is None or (braid.angle is None and braid.angle_from_axis is None):
        if rope.pitch is None:
            other = ", or give braid.angle, in degrees" if braid is not None else ""
            raise SceneError("rope.pitch", f"missing, add it, in mm{other}.")
        return rope.pitch
    name, angle, slope = _slope(braid)
    pitch = 2.0 * math.pi * braid.helix_radius * slope
    if rope.pitch is None:
        return pitch
    if abs(rope.pitch - pitch) > AGREE * pitch:
        cure = f"{name} = {angle:g} degrees gives {pitch:.10g} mm; leave one of the two out."
        raise SceneError("rope.pitch", cure, rope.pitch)
    return rope.pitch


def _slope(braid: BraidRecipe) -> tuple[str, float, float]:
    """Name of the angle given, its value in degrees, and the way along the axis per way round it."""
    if braid.angle is not None:
        return "braid.angle", braid.angle, math.tan(math.radians(braid.angle))
    assert braid.angle_from_axis is not None
    slope = 1.0 / math.tan(math.radians(braid.angle_from_axis))
    return "braid.angle_from_axis", braid.angle_from_axis, slope
