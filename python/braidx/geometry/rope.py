"""Places the yarns of a scene."""

from __future__ import annotations

import numpy as np

from braidx.geometry.checks import check_geometry
from braidx.geometry.end_groups import check_end_groups
from braidx.geometry.crossings import Crossings, find_crossings, no_crossings
from braidx.geometry.helix import outside, place_yarn
from braidx.geometry.motif import motif_matrix
from braidx.geometry.start_configuration import Rope
from braidx.geometry.strand import laid_pitch, strand_section, yarn_pitch
from braidx.geometry.strands import lay_sense, strand_helices
from braidx.scene.scene import Scene


def build_rope(scene: Scene, pitches: int | None = None) -> Rope:
    """Place the yarns of a scene in their start configuration, interpenetrating as they are.

    Args:
        scene: The scene.
        pitches: Length of what is placed, in pitches; None: that of the scene's sample.
    Raises:
        SceneError: If the recipe cannot be placed (see `check_geometry`), or groups of its ends make no sense.
    """
    check_geometry(scene)
    pitches = scene.rope.pitches if pitches is None else pitches
    length = scene.rope.pitch * pitches
    intervals = scene.yarn.elements_per_pitch * pitches * scene.yarn.degree
    z = np.linspace(0.0, length, intervals + 1, dtype=np.float64)
    helices, layer = strand_helices(scene)
    section = strand_section(scene.strand, scene.yarn.radius, laid_pitch(scene))
    pitch = yarn_pitch(scene.strand, scene.rope.pitch)
    # Braids are formed: what they start from may overlap.
    turn = 0.0 if scene.braid is not None else 2.0 * np.pi / pitch * float(z[1])
    rings = [outside(radius, turn) for radius in section.ring_radius]
    places = list(zip(rings, section.phase, strict=True))
    lines = tuple(
        place_yarn(
            helix, radius, phase, lay_sense(scene.strand.lay, helix) * 2.0 * np.pi / pitch, z
        )
        for helix in helices
        for radius, phase in places
    )
    rope = Rope(
        centre_lines=lines,
        radius=np.full(len(lines), scene.yarn.radius),
        strand=np.repeat(np.arange(len(helices)), section.num_yarns),
        layer=layer,
        strand_lines=tuple(helix.point(z) for helix in helices),
        crossings=_crossings(scene, length),
        length=length,
        pitch=scene.rope.pitch,
    )
    check_end_groups(scene, rope)
    return rope


def _crossings(scene: Scene, length: float) -> Crossings:
    if scene.braid is None:
        return no_crossings()
    counts = scene.braid.strands_per_direction
    matrix = motif_matrix(scene.braid.motif)
    return find_crossings(matrix, (counts[0], counts[1]), scene.rope.pitch, length)
