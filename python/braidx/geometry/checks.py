"""Checks of a recipe's geometry: what one field cannot know about another."""

from __future__ import annotations

import math

from braidx.geometry.bending_checks import check_bent_rope
from braidx.geometry.closed_forms import helix_angle
from braidx.geometry.helix import MOST_TURN
from braidx.geometry.jamming import check_jamming
from braidx.geometry.motif import check_motif, motif_matrix
from braidx.geometry.strand import laid_pitch, largest_yarn_radius, ring_radii, yarn_pitch
from braidx.geometry.undulation_checks import check_undulation
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene


def check_geometry(scene: Scene) -> None:
    """Raises SceneError, with the cure, where the rope of a scene cannot be placed."""
    _check_yarn_pitch(scene)
    _check_rings(scene)
    _check_laid(scene)
    _check_slope(scene)
    if scene.braid is not None:
        counts = (scene.braid.strands_per_direction[0], scene.braid.strands_per_direction[1])
        check_motif(motif_matrix(scene.braid.motif), counts)
        check_jamming(scene)
        check_undulation(scene)
    check_bent_rope(scene, num_yarns(scene))


def num_yarns(scene: Scene) -> int:
    """Yarns of a scene's rope."""
    strands = 1 if scene.braid is None else sum(scene.braid.strands_per_direction)
    return strands * sum(scene.strand.rings)


def _check_yarn_pitch(scene: Scene) -> None:
    turns = scene.rope.pitch / yarn_pitch(scene.strand, scene.rope.pitch)
    if abs(turns - round(turns)) > 1e-9 * max(turns, 1.0):
        pitch = scene.rope.pitch
        near = sorted({max(1, math.floor(turns)), math.ceil(turns)})
        cures = " or ".join(f'{pitch / n:.6g} mm ("pitch/{n}")' for n in near)
        raise SceneError(
            "strand.yarn_pitch",
            f"rope.pitch = {pitch:g} mm is not a multiple of it, so the sample would not be "
            f"periodic; use {cures}.",
            scene.strand.yarn_pitch,
        )


def _check_rings(scene: Scene) -> None:
    largest = largest_yarn_radius(scene.strand)
    if scene.yarn.radius > largest:
        rings = " + ".join(map(str, scene.strand.rings))
        raise SceneError(
            "yarn.radius",
            f"{rings} yarns overlap with strand.helix_radius = {scene.strand.helix_radius} mm; use "
            f'at most {largest:.4g} mm, or strand.helix_radius = "touching".',
            scene.yarn.radius,
        )


def _check_laid(scene: Scene) -> None:
    """Yarns of a strand that is not in a braid lie beside each other, on helices with enough nodes in a turn."""
    pitch = laid_pitch(scene)
    if math.isinf(max(ring_radii(scene.strand, scene.yarn.radius, pitch))):
        least = 2.0 * scene.yarn.radius * max(scene.strand.rings)
        raise SceneError(
            "strand.yarn_pitch",
            f"{max(scene.strand.rings)} yarns of radius {scene.yarn.radius:g} mm find no room beside each other; "
            f"use more than {least:.4g} mm.",
            scene.strand.yarn_pitch,
        )
    spans = scene.yarn.elements_per_pitch * scene.yarn.degree
    least = 2.0 * math.pi / MOST_TURN * scene.rope.pitch / pitch  # 0 where nothing is twisted
    if max(scene.strand.rings) > 1 and spans < least * (1.0 - 1e-9):
        raise SceneError(
            "yarn.elements_per_pitch",
            f"a yarn has fewer than four spans between nodes in a turn; use at least "
            f"{math.ceil(least / scene.yarn.degree)}.",
            scene.yarn.elements_per_pitch,
        )


def _check_slope(scene: Scene) -> None:
    """Yarns must advance along the axis everywhere."""
    radius = scene.braid.helix_radius if scene.braid is not None else 0.0
    angle = helix_angle(radius, scene.rope.pitch)
    pitch = yarn_pitch(scene.strand, scene.rope.pitch)
    outermost = max(ring_radii(scene.strand, scene.yarn.radius))
    if outermost * math.sin(angle) * 2.0 * math.pi / pitch > 0.8:
        least = outermost * math.sin(angle) * 2.0 * math.pi / 0.8
        raise SceneError(
            "strand.yarn_pitch",
            f"yarns would turn back along the axis; use at least {least:.4g} mm.",
            scene.strand.yarn_pitch,
        )
