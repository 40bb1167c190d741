"""The section of a strand: where its yarns lie around its centre line."""

from __future__ import annotations

import math
from dataclasses import dataclass

from braidx.scene.recipe import StrandRecipe

OVERLAP_ALLOWED = 0.1  # of a yarn's diameter, at the start; forming pushes the yarns apart


@dataclass(frozen=True)
class StrandSection:
    """Places of the yarns in the plane normal to the strand; one entry per yarn. Lengths in mm."""

    ring_radius: tuple[float, ...]  # distance from the centre line
    phase: tuple[float, ...]  # angle at the start of the sample, radians
    outer_radius: float  # of the strand

    @property
    def num_yarns(self) -> int:
        return len(self.phase)


def touching_radius(count: int, yarn_radius: float, around_yarn: bool) -> float:
    """Smallest radius of a ring of yarns that overlap neither each other nor a central yarn, mm."""
    if count == 1 and not around_yarn:
        return 0.0
    between = yarn_radius / math.sin(math.pi / count) if count > 1 else 0.0
    return max(between, 2.0 * yarn_radius if around_yarn else 0.0)


def ring_radii(recipe: StrandRecipe, yarn_radius: float) -> tuple[float, ...]:
    """Radius of each ring, mm; a single yarn in the first ring lies on the centre line."""
    central = recipe.rings[0] == 1
    first = 1 if central else 0
    radii = [0.0] * first
    for ring in range(first, len(recipe.rings)):
        if recipe.helix_radius == "touching":
            radius = touching_radius(recipe.rings[ring], yarn_radius, ring > 0)
            radii.append(max(radius, radii[-1] + 2.0 * yarn_radius) if radii else radius)
        else:
            radii.append(float(recipe.helix_radius) + 2.0 * yarn_radius * (ring - first))
    return tuple(radii)


def largest_yarn_radius(recipe: StrandRecipe) -> float:
    """Largest yarn radius, mm, with which the rings are free of overlap up to OVERLAP_ALLOWED."""
    if recipe.helix_radius == "touching":
        return math.inf
    limits = [math.inf]
    for ring, count in enumerate(recipe.rings):
        outward = ring - (1 if recipe.rings[0] == 1 else 0)
        if outward < 0:
            continue
        # a ring of radius helix_radius + 2 r outward: touching where r = radius * fraction
        radius = float(recipe.helix_radius)
        if count > 1:
            fraction = math.sin(math.pi / count)
            slack = 1.0 - OVERLAP_ALLOWED - 2.0 * outward * fraction
            limits.append(radius * fraction / slack if slack > 0.0 else math.inf)
        if ring > 0 and outward == 0:
            limits.append(radius / 2.0 / (1.0 - OVERLAP_ALLOWED))
    return min(limits)


def strand_section(recipe: StrandRecipe, yarn_radius: float) -> StrandSection:
    """Lay out the yarns of a strand, ring by ring from the inside out."""
    radii = ring_radii(recipe, yarn_radius)
    places = [
        (radius, 2.0 * math.pi * k / count)
        for radius, count in zip(radii, recipe.rings, strict=True)
        for k in range(count)
    ]
    return StrandSection(
        ring_radius=tuple(radius for radius, _ in places),
        phase=tuple(phase for _, phase in places),
        outer_radius=radii[-1] + yarn_radius,
    )


def yarn_pitch(recipe: StrandRecipe, rope_pitch: float) -> float:
    """Pitch of the yarns around their strand along the rope's axis, mm; infinite if untwisted."""
    if recipe.yarn_pitch == "untwisted":
        return math.inf
    if isinstance(recipe.yarn_pitch, str):
        return rope_pitch / int(recipe.yarn_pitch.partition("/")[2])
    return recipe.yarn_pitch
