"""Results of a bent rope: which numbers are taken from which state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...geometry import build_rope
from ...output.bending_measures import (
    core_pressure_max,
    von_mises_max,
    yarn_sheave_force_max,
)
from ...output.interlacing import relative_displacement
from ...output.interlacing_points import InterlacingPoints, crossing, find_interlacing, radial
from ...output.rope_axis import RopeAxis, mean_axis
from ...output.snapshot import Snapshot
from ...output.yarn_curves import YarnCurves
from ...system.constraints import Floats
from ..state import State

if TYPE_CHECKING:
    from .model import BentRope

NEAR = 1e-9  # mm


def bent_results(model: BentRope, state: State, picture: Snapshot) -> dict[str, float]:
    """Results of a state worth a picture: of the last one in which the rope is bent as far as it has been.

    NaN is what the run does not have: the work of a cycle before one is complete, stress in a scene without solids.
    """
    results = {"friction_work_per_cycle": state.progress.get("cycle_work", np.nan)}
    if not _is_bent(state):
        return results
    results |= {
        **_slip(model, picture),
        **_shares(model),
        "end_force": float(np.abs(model.end_forces(state.q)).mean()),
        "yarn_sheave_force_max": yarn_sheave_force_max(picture),
        "core_pressure_max": core_pressure_max(picture),
        "sheave_angle": float(np.degrees(state.progress["sheave_angle"])),
        "von_mises_max": von_mises_max(picture) if picture.skins else np.nan,
    }
    return results


def _shares(model: BentRope) -> dict[str, float]:
    """How much of the yarns is modelled as what."""
    elements = {"cable": 0, "beam": 0, "solid": 0}
    for stretch in model.assembly.stretches:
        elements[stretch.model] += stretch.last - stretch.first
    return {f"{name}_share": count / sum(elements.values()) for name, count in elements.items()}


def _is_bent(state: State) -> bool:
    travel = state.progress["travel"]
    return bool(travel > 0.0 and travel >= state.progress["furthest"] - NEAR)


def _slip(model: BentRope, picture: Snapshot) -> dict[str, float]:
    rope = build_rope(model.scene)
    layer = rope.layer[rope.strand]
    axes = mean_axis(model.lines), mean_axis(picture.centre_lines)
    points = find_interlacing(model.lines, picture.radius, layer, axes[0])
    slid = relative_displacement(
        model.lines, picture.centre_lines, picture.radius, layer, points, axes
    )
    wrong = wrong_sides(model.lines, picture.centre_lines, points, axes)
    return {
        "relative_displacement": slid.mean_at_crown(model.scene.crown),
        "relative_displacement_max": slid.maximum(),
        "crossing_points": float(len(points)),
        "wrong_side_crossings": float(wrong),
    }


def wrong_sides(
    before: Sequence[Floats],
    now: Sequence[Floats],
    points: InterlacingPoints,
    axes: tuple[RopeAxis, RopeAxis],
) -> int:
    """Number of crossings where the yarn that was outside is inside.

    Args:
        before, now: Centre lines of all yarns in two states, shape (num_nodes, 3) each, mm.
        points: Interlacing points of the first state.
        axes: Of the rope in both.
    """
    outside = []
    for lines, axis in zip((before, now), axes, strict=True):
        curves = YarnCurves(lines)
        s_a, s_b, found = crossing(
            curves, axis, points.yarn_a, points.yarn_b, points.s_a, points.s_b
        )
        a, b = curves(points.yarn_a, s_a), curves(points.yarn_b, s_b)
        height = np.einsum("ij,ij->i", b - a, radial(axis, 0.5 * (a + b)))
        outside.append(np.where(found, np.sign(height), 0.0))
    return int(np.sum(outside[0] * outside[1] < 0.0))
