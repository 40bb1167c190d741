"""Strands of one direction find room beside each other, or the braid jams."""

from __future__ import annotations

import math

from braidx.geometry.closed_forms import helix_angle, jamming_angle, line_cover, strand_share
from braidx.geometry.strand import OVERLAP_ALLOWED, strand_section
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene

ROUND_OFF = 1e-9


def check_jamming(scene: Scene) -> None:
    """Raises SceneError where strands of one direction would cover more than the whole cylinder.

    Strands of several yarns flatten, and may overlap by OVERLAP_ALLOWED of their width; single yarns may not.
    """
    assert scene.braid is not None
    count, radius = max(scene.braid.strands_per_direction), scene.braid.helix_radius
    section = strand_section(scene.strand, scene.yarn.radius)
    allowed = OVERLAP_ALLOWED if section.num_yarns > 1 else 0.0
    width = 2.0 * section.outer_radius * (1.0 - allowed)
    angle = helix_angle(radius, scene.rope.pitch)
    if count == 1 or line_cover(2 * count, width, radius, angle) <= 1.0 + ROUND_OFF:
        return
    share = strand_share(count, radius, scene.rope.pitch)
    at_zero = strand_section(scene.strand, 0.0).outer_radius
    half = share / (2.0 * (1.0 - allowed))
    largest = scene.yarn.radius * (half - at_zero) / (section.outer_radius - at_zero)
    cures = [f"at most {largest:.4g} mm"] if largest > 0.0 else []
    cures += _radius_cure(scene, count, width, angle) + _angle_cure(count, width, radius)
    raise SceneError(
        "yarn.radius",
        f"{count} strands of diameter {2.0 * section.outer_radius:.4g} mm per direction jam: braid.helix_radius = "
        f"{radius:g} mm leaves each {share:.4g} mm; use {' or '.join(cures)}.",
        scene.yarn.radius,
    )


def _radius_cure(scene: Scene, count: int, width: float, angle: float) -> list[str]:
    """Smallest helix radius, at the angle or the pitch that the scene gives."""
    assert scene.braid is not None
    around = count * width
    if scene.braid.angle is None and scene.braid.angle_from_axis is None:
        if around >= scene.rope.pitch:
            return []
        smallest = around / (2.0 * math.pi * math.sqrt(1.0 - (around / scene.rope.pitch) ** 2))
    else:
        smallest = around / (2.0 * math.pi * math.cos(angle))
    return [f"braid.helix_radius at least {math.ceil(1e3 * smallest) / 1e3:g} mm"]


def _angle_cure(count: int, width: float, radius: float) -> list[str]:
    steepest = jamming_angle(2 * count, width, radius)
    if not steepest:
        return []
    degrees = math.floor(1e2 * math.degrees(steepest)) / 1e2
    pitch = 2.0 * math.pi * radius / math.tan(math.radians(degrees))
    return [f"an angle of at most {degrees:g} degrees from the axis (rope.pitch = {pitch:.4g} mm)"]
