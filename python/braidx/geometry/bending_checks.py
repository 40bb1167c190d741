"""Checks of a rope that is bent: its core fits into the braid, the rope into the groove, its yarns exist."""

from __future__ import annotations

from braidx.geometry.strand import OVERLAP_ALLOWED, laid_pitch, strand_section
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene


def check_bent_rope(scene: Scene, num_yarns: int) -> None:
    """Raises SceneError, with the cure, where core, sheave or models do not suit the rope."""
    _check_core(scene)
    _check_groove(scene)
    for number, model in scene.yarn.models.items():
        if int(number) >= num_yarns:
            cure = f"no such yarn; use numbers from 0 to {num_yarns - 1}."
            raise SceneError(f"yarn.models.{number}", cure, model)


def inner_radius(scene: Scene) -> float:
    """Room within the braid at the start, from the axis to the innermost yarns, mm."""
    assert scene.braid is not None
    return scene.braid.helix_radius - scene.braid.undulation - _strand_radius(scene)


def outer_diameter(scene: Scene) -> float:
    """Diameter of the rope at the start, 2 (helix_radius + undulation + radius of a strand), mm.

    A rope that is one strand has that strand's diameter.
    """
    if scene.braid is None:
        return 2.0 * _strand_radius(scene)
    return 2.0 * (scene.braid.helix_radius + scene.braid.undulation + _strand_radius(scene))


def _strand_radius(scene: Scene) -> float:
    return strand_section(scene.strand, scene.yarn.radius, laid_pitch(scene)).outer_radius


def _check_core(scene: Scene) -> None:
    if scene.core is None:
        return
    largest = inner_radius(scene) + OVERLAP_ALLOWED * scene.yarn.radius
    if scene.core.radius <= largest:
        return
    cure = f"use at most {largest:.4g} mm" if largest > 0.0 else "no core fits in there"
    raise SceneError(
        "core.radius",
        f"too thick, the yarns leave {inner_radius(scene):.4g} mm (braid.helix_radius less braid.undulation and the "
        f"radius of a strand); {cure}, or a larger braid.helix_radius.",
        scene.core.radius,
    )


def _check_groove(scene: Scene) -> None:
    if scene.sheave is None or scene.sheave.groove_radius is None:
        return
    radius = outer_diameter(scene) / 2.0
    if scene.sheave.groove_radius < radius:
        cure = f"narrower than the rope; use at least its radius, {radius:.4g} mm."
        raise SceneError("sheave.groove_radius", cure, scene.sheave.groove_radius)
