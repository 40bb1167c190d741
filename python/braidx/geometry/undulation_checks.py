"""Checks of strands that wind out and in: they repeat with the pitch, climb everywhere, and do not fold."""

from __future__ import annotations

import math

import numpy as np

from braidx.geometry.helix import StrandHelix, climb
from braidx.geometry.motif import closes, motif_matrix, repeats
from braidx.geometry.strand import ring_radii, yarn_pitch
from braidx.geometry.strands import strand_helices
from braidx.scene.bending import Bend
from braidx.scene.errors import SceneError
from braidx.scene.rules import SOLID
from braidx.scene.scene import Scene
from braidx.scene.steps import Form

LEAST_CLIMB = (
    0.2  # of a yarn per height of its strand, as `check_geometry` asks for without undulation
)


def check_undulation(scene: Scene) -> None:
    """Raises SceneError, with the cure, where the undulation of a scene's strands cannot be placed."""
    assert scene.braid is not None
    if scene.braid.undulation == 0.0:
        return
    _check_repeats(scene)
    _check_climb(scene)
    _check_folds(scene)


def sharpest_bend(scene: Scene) -> float:
    """Smallest radius of curvature of the strands' centre lines at the start, mm."""
    return min(_smallest_radius(helix, scene.rope.pitch) for helix in strand_helices(scene)[0])


def _check_repeats(scene: Scene) -> None:
    assert scene.braid is not None
    motif, counts = motif_matrix(scene.braid.motif), scene.braid.strands_per_direction
    if repeats(motif, counts[1]):
        return
    fitting = [n for n in range(1, 65) if closes(motif, (n, n)) and repeats(motif, n)]
    near = min(fitting, key=lambda n: abs(n - max(counts)), default=0)
    strands = f" or braid.strands_per_direction = [{near}, {near}]" if near else ""
    cure = (
        f"sides of {counts[0]} + {counts[1]} strands do not repeat with rope.pitch in this braid.motif, so the sample "
        f"would not be periodic; use 0{strands}."
    )
    raise SceneError("braid.undulation", cure, scene.braid.undulation)


def _check_climb(scene: Scene) -> None:
    """Yarns about an undulating strand must advance along the axis everywhere."""
    assert scene.braid is not None
    outermost = max(ring_radii(scene.strand, scene.yarn.radius))
    rate = 2.0 * np.pi / yarn_pitch(scene.strand, scene.rope.pitch)
    if outermost == 0.0:
        return
    least = min(
        climb(helix, outermost, turn, way * rate, _heights(helix, scene.rope.pitch)).min()
        for helix in strand_helices(scene)[0]
        for turn in np.arange(8) * np.pi / 4.0
        for way in (1, -1)
    )
    if least < LEAST_CLIMB:
        cure = (
            f"yarns at {outermost:.4g} mm from the centre line of a strand would turn back along the axis; use less, "
            "a longer pitch or thinner strands."
        )
        raise SceneError("braid.undulation", cure, scene.braid.undulation)


def _check_folds(scene: Scene) -> None:
    """A solid yarn that is placed and not formed must not be bent more sharply than its own radius."""
    assert scene.braid is not None
    solid = scene.yarn.model in SOLID or any(m in SOLID for m in scene.yarn.models.values())
    formed = any(isinstance(step, Form) for step in scene.steps)
    if not solid or formed or not any(isinstance(step, Bend) for step in scene.steps):
        return
    smallest = sharpest_bend(scene)
    if smallest <= scene.yarn.radius:
        cure = (
            f"bends strands to a radius of {smallest:.4g} mm, and solid yarns of radius {scene.yarn.radius:g} mm would "
            'fold; use less, an angle nearer to the axis, or a step kind = "form".'
        )
        raise SceneError("braid.undulation", cure, scene.braid.undulation)


def _heights(helix: StrandHelix, pitch: float) -> np.ndarray:
    """Heights of one pitch, close enough for the sharpest bends."""
    crossings = len(helix.undulation.side) if helix.undulation is not None else 1
    return np.linspace(0.0, pitch, 64 * crossings + 1)


def _smallest_radius(helix: StrandHelix, pitch: float) -> float:
    z = _heights(helix, pitch)
    step = z[1]
    before, here, after = (helix.point(z + way * step) for way in (-1, 0, 1))
    tangent, bend = (after - before) / (2.0 * step), (after - 2.0 * here + before) / step**2
    speed = np.linalg.norm(tangent, axis=1)
    curvature = np.linalg.norm(np.cross(tangent, bend), axis=1) / speed**3
    sharpest = float(curvature.max())
    return 1.0 / sharpest if sharpest > 0.0 else math.inf
