"""Tubes and surfaces that a bent rope is drawn with."""

from __future__ import annotations

from enum import Enum

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import Normalize, to_rgb
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from braidx.output.figures.style import yarn_colours
from braidx.output.figures.swept import swept
from braidx.output.figures.triangles import Triangles, smooth_normals
from braidx.output.skin_picture import SkinPicture
from braidx.output.snapshot import Array, Snapshot

STRESS_MAP = colormaps["viridis"]
CORE_COLOUR = to_rgb("#b9b1a1")
_HOLE_COLOUR = to_rgb("#4a4640")
_UNKNOWN = to_rgb("#c9ccd1")
_NEAR = 1.15  # yarn radii from a skin: there the tube of the yarn lies within the skin


class Colouring(Enum):
    """What colours mean."""

    YARN = "yarn"
    STRESS = "stress"


def shapes(
    snapshot: Snapshot, colouring: Colouring, scale: Normalize | None = None
) -> list[Triangles]:
    """Everything of the rope; what is drawn as a surface is not drawn as a tube as well.

    Args:
        snapshot: The rope.
        colouring: By yarn, or by stress: von Mises on surfaces, magnitude of the axial stress on
            tubes, which is the same in a yarn that is only pulled.
        scale: Of the stress, MPa.
    """
    yarns = yarn_colours(snapshot)
    parts = _core_tubes(snapshot)
    if colouring is Colouring.STRESS and scale is not None and snapshot.axial_stress is not None:
        colours = [STRESS_MAP(scale(np.abs(s)))[:, :3] for s in snapshot.axial_stress]
    elif colouring is Colouring.STRESS:
        colours = [np.array([_UNKNOWN])] * snapshot.num_yarns
    else:
        colours = list(yarns[:, None])
    for yarn in range(snapshot.num_yarns):
        line, colour = snapshot.centre_lines[yarn], colours[yarn]
        for first, last in _bare_stretches(snapshot, yarn):
            piece = colour[first : last - 1] if len(colour) > 1 else colour
            parts.append(swept(line[first:last], float(snapshot.radius[yarn]), piece))
    for skin in snapshot.skins:
        if colouring is Colouring.STRESS and scale is not None:
            colour = STRESS_MAP(scale(skin.von_mises))[:, :3]
            colour = np.where(np.isfinite(skin.von_mises)[:, None], colour, _UNKNOWN)
        else:
            colour = np.concatenate([yarns, [CORE_COLOUR]])[skin.owner]  # -1 is the core
        # What the stress is inside, a skin does not know.
        inside = np.tile(_UNKNOWN, (len(colour), 1)) if colouring is Colouring.STRESS else colour
        parts.append(_surface(skin, colour, inside))
    return parts


def stresses(snapshot: Snapshot) -> Array:
    """All stresses that `shapes` shows, MPa; empty if there are none."""
    found = [skin.von_mises[np.isfinite(skin.von_mises)] for skin in snapshot.skins]
    if snapshot.axial_stress is not None:
        for yarn, stress in enumerate(snapshot.axial_stress):
            covered = _covered(snapshot, yarn)
            found.append(np.abs(stress[~(covered[1:] & covered[:-1])]))
    return np.concatenate([np.empty(0), *found])


def _covered(snapshot: Snapshot, yarn: int) -> NDArray[np.bool_]:
    """Whether nodes of a yarn's centre line lie within a skin of that yarn."""
    line = snapshot.centre_lines[yarn]
    covered = np.zeros(len(line), dtype=bool)
    for skin in snapshot.skins:
        faces = skin.faces[skin.owner == yarn]
        if len(faces):
            corners = skin.points[faces]
            places = np.concatenate([corners.reshape(-1, 3), corners.mean(axis=1)])
            distance = cKDTree(places).query(line)[0]
            covered |= distance < _NEAR * snapshot.radius[yarn]
    return covered


def _bare_stretches(snapshot: Snapshot, yarn: int) -> list[tuple[int, int]]:
    """Runs of nodes first ... last - 1 of a yarn that no skin covers, two nodes or more."""
    bare = ~_covered(snapshot, yarn)
    # A tube reaches to the first node within the skin, so that no gap is left between them.
    bare[1:-1] |= bare[:-2] | bare[2:]
    ends = np.flatnonzero(np.diff(np.concatenate([[0], bare.astype(int), [0]])))
    return [(int(a), int(b)) for a, b in ends.reshape(-1, 2) if b - a > 1]


def _core_tubes(snapshot: Snapshot) -> list[Triangles]:
    """The core as a tube, with its bore on top where a cut shows it; none if it has a skin."""
    core = snapshot.core
    if core is None or any((skin.owner == -1).any() for skin in snapshot.skins):
        return []
    radii = [(core.radius, CORE_COLOUR)]
    if core.inner_radius > 0.0:
        radii.append((core.inner_radius, _HOLE_COLOUR))
    return [swept(core.line, radius, np.array([colour])) for radius, colour in radii]


def _surface(skin: SkinPicture, colour: Array, inside: Array) -> Triangles:
    corners, face = skin.triangles()
    normals = smooth_normals(skin.points, corners)
    return Triangles(skin.points, normals, corners, colour[face], inside[face])
