"""Surfaces that a rope, straight or bent, is drawn with."""

from __future__ import annotations

from collections.abc import Sequence
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
LEAST_SPAN = 0.1  # of the mean magnitude: narrower scales would show noise in full colour
_NEAR = 1.15  # yarn radii from a skin: there the tube of the yarn lies within the skin


class Colouring(Enum):
    """What colours mean."""

    YARN = "yarn"
    STRESS = "stress"


def shapes(
    snapshot: Snapshot,
    scale: Normalize | None = None,
    yarns: Sequence[int] | None = None,
) -> list[Triangles]:
    """Everything of the rope; what is drawn as a skin is not drawn as a tube as well.

    Args:
        snapshot: The rope.
        scale: Of the axial stress of yarns, MPa, positive in tension, to colour them by; None colours them by
            layer and strand. The core keeps its colour.
        yarns: The yarns to show, without the core; None shows all and the core.
    """
    parts = _core_tubes(snapshot) if yarns is None else []
    own = yarn_colours(snapshot)
    shown = range(snapshot.num_yarns) if yarns is None else yarns
    for yarn in shown:
        line, colour = snapshot.centre_lines[yarn], _tube_colour(snapshot, yarn, own, scale)
        for first, last in _bare_stretches(snapshot, yarn):
            piece = colour[first : last - 1] if len(colour) > 1 else colour
            parts.append(swept(line[first:last], float(snapshot.radius[yarn]), piece))
    for skin in snapshot.skins if yarns is None else ():
        colour = np.concatenate([own, [CORE_COLOUR]])[skin.owner]  # -1 is the core
        inside = colour
        if scale is not None:
            stressed = np.isfinite(skin.axial_stress)
            with_stress = np.asarray(STRESS_MAP(scale(np.nan_to_num(skin.axial_stress))))[:, :3]
            colour = np.where(stressed[:, None], with_stress, colour)
            # Skins have no stress of the section that a cut shows.
            inside = np.where(stressed[:, None], _UNKNOWN, colour)
        parts.append(_surface(skin, colour, inside))
    return parts


def stress_scale(snapshot: Snapshot) -> Normalize:
    """Scale of the axial stresses that `shapes` shows, MPa.

    It leaves out the extreme hundredths, and spans at least a tenth of the mean magnitude: differences below that are
    shown as what they are, small.

    Raises:
        ValueError: If the snapshot has no stress.
    """
    return scale_of(stresses(snapshot), f"Snapshot {snapshot.name!r}")


def stresses(snapshot: Snapshot) -> Array:
    """All axial stresses that `shapes` shows, MPa; empty if there are none."""
    found = [skin.axial_stress[np.isfinite(skin.axial_stress)] for skin in snapshot.skins]
    if snapshot.axial_stress is not None:
        for yarn, stress in enumerate(snapshot.axial_stress):
            covered = _covered(snapshot, yarn)
            found.append(stress[~(covered[1:] & covered[:-1])])
    return np.concatenate([np.empty(0), *found])


def scale_of(values: Array, owner: str) -> Normalize:
    """Scale of some values without their extreme hundredths, at least `LEAST_SPAN` of their mean magnitude wide.

    Raises:
        ValueError: If there are no values.
    """
    if not len(values):
        raise ValueError(f"{owner} has no stress; store it when saving.")
    low, high = np.percentile(values, [1, 99])
    least = max(LEAST_SPAN * float(np.abs(values).mean()), np.finfo(float).tiny)
    if high - low < least:
        middle = 0.5 * (low + high)
        low, high = middle - 0.5 * least, middle + 0.5 * least
    return Normalize(float(low), float(high))


def _tube_colour(snapshot: Snapshot, yarn: int, own: Array, scale: Normalize | None) -> Array:
    """Colour of a yarn's tube, shape (1, 3), or per segment where stresses are shown."""
    if scale is None:
        return own[yarn][None]
    if snapshot.axial_stress is None:
        return np.array([_UNKNOWN])
    return np.asarray(STRESS_MAP(scale(snapshot.axial_stress[yarn])))[:, :3]


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
