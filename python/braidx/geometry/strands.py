"""The strands of a scene: how many, where, and how they wind."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.crossings import phase_offset
from braidx.geometry.helix import StrandHelix
from braidx.geometry.motif import motif_matrix
from braidx.geometry.undulation import Undulation
from braidx.scene.scene import Scene

Integers = NDArray[np.int64]


def strand_helices(scene: Scene) -> tuple[list[StrandHelix], Integers]:
    """Centre lines of all strands, layer 0 first, and the layer of each."""
    pitch = scene.rope.pitch
    if scene.braid is None:
        return [StrandHelix(0.0, np.inf, 1, 0.0)], np.zeros(1, dtype=np.int64)
    counts = scene.braid.strands_per_direction
    offset = phase_offset((counts[0], counts[1]))
    radius = scene.braid.helix_radius
    helices = [
        StrandHelix(
            radius, pitch, sense, start + 2.0 * np.pi * k / count, _undulation(scene, layer, k)
        )
        for layer, (sense, start, count) in enumerate(
            ((1, 0.0, counts[0]), (-1, offset, counts[1]))
        )
        for k in range(count)
    ]
    return helices, np.repeat(np.arange(2), counts)


def lay_sense(lay: str, helix: StrandHelix) -> int:
    """Sense of the yarns of a strand, +1 right-handed."""
    return {"Z": 1, "S": -1, "same": helix.sense, "opposite": -helix.sense}[lay]


def _undulation(scene: Scene, layer: int, k: int) -> Undulation | None:
    """Out where the motif has strand k of a layer outside: see `find_crossings` for where it crosses which line."""
    assert scene.braid is not None
    if scene.braid.undulation == 0.0:
        return None
    counts, pitch = scene.braid.strands_per_direction, scene.rope.pitch
    motif = motif_matrix(scene.braid.motif)
    shift = pitch * phase_offset((counts[0], counts[1])) / (4.0 * np.pi)
    passed = np.arange(2 * counts[1 - layer])  # crossings of one pitch, by z
    if layer == 0:
        side = motif[k % motif.shape[0], passed % motif.shape[1]]
        first = shift - pitch / 2.0 * k / counts[0]
    else:
        side = -motif[-passed % motif.shape[0], k % motif.shape[1]]
        first = shift + pitch / 2.0 * k / counts[1]
    return Undulation(scene.braid.undulation, first, pitch / len(passed), side)
