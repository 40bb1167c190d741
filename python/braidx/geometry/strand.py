"""The section of a strand: where its yarns lie around its centre line."""

from __future__ import annotations

import math
from dataclasses import dataclass

from scipy.optimize import brentq

from braidx.scene.recipe import StrandRecipe
from braidx.scene.scene import Scene

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


def touching_radius(
    count: int, yarn_radius: float, around_yarn: bool, pitch: float = math.inf
) -> float:
    """Smallest radius of a ring of yarns that overlap neither each other nor a central yarn, mm.

    Neighbours on helices are nearest where one is an angle u < a behind on its way, a = 2 pi / count: the square of
    their distance, 2 R^2 (1 - cos(a - u)) + (k u)^2 with k = pitch / (2 pi), has its minimum there if
    R^2 sin(a - u) = k^2 u. Together: u^2 + 2 u tan((a - u) / 2) = (2 yarn_radius / k)^2.

    Args:
        pitch: Of the yarns' helices about a straight axis, mm; infinite: they are parallel.
    """
    if count == 1 and not around_yarn:
        return 0.0
    between = _apart(count, yarn_radius, pitch) if count > 1 else 0.0
    return max(between, 2.0 * yarn_radius if around_yarn else 0.0)


def _apart(count: int, yarn_radius: float, pitch: float) -> float:
    """Radius on which yarns touch their neighbours, mm; infinite where the pitch has no room for all."""
    parallel = yarn_radius / math.sin(math.pi / count)
    if count == 2 or yarn_radius == 0.0 or math.isinf(pitch):  # two are nearest across the axis
        return parallel
    angle, k = 2.0 * math.pi / count, pitch / (2.0 * math.pi)
    wanted = (2.0 * yarn_radius / k) ** 2

    def missing(u: float) -> float:
        return u**2 + 2.0 * u * math.tan((angle - u) / 2.0) - wanted

    if missing(angle) <= 0.0:
        return math.inf
    u = float(brentq(missing, 0.0, angle, xtol=1e-300, rtol=1e-15))  # relative: u may be tiny
    return k * math.sqrt(u / math.sin(angle - u))


def ring_radii(
    recipe: StrandRecipe, yarn_radius: float, pitch: float = math.inf
) -> tuple[float, ...]:
    """Radius of each ring, mm; a single yarn in the first ring lies on the centre line. `pitch`: see `laid_pitch`."""
    central = recipe.rings[0] == 1
    first = 1 if central else 0
    radii = [0.0] * first
    for ring in range(first, len(recipe.rings)):
        if recipe.helix_radius == "touching":
            radius = touching_radius(recipe.rings[ring], yarn_radius, ring > 0, pitch)
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


def strand_section(
    recipe: StrandRecipe, yarn_radius: float, pitch: float = math.inf
) -> StrandSection:
    """Lay out the yarns of a strand, ring by ring from the inside out. `pitch`: see `laid_pitch`."""
    radii = ring_radii(recipe, yarn_radius, pitch)
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


def laid_pitch(scene: Scene) -> float:
    """Pitch of the helices whose yarns are placed without overlap, mm: those of a strand that is not in a braid.

    Infinite in braids, where yarns of a strand are placed as if they were parallel: forming takes them apart.
    """
    return math.inf if scene.braid is not None else yarn_pitch(scene.strand, scene.rope.pitch)
