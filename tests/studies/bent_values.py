"""Numbers taken from a run of a rope that was bent over a sheave (paper 2)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from summaries import summary_values

from braidx.geometry.bending_checks import outer_diameter
from braidx.geometry.bent_helix import bend_radius, frictionless_slip
from braidx.processes.bending.crossings import FILE, read_crossings
from braidx.scene import Scene

SLIP = "relative displacement (mm)"  # the paper's: mean of the four crossings nearest to the crown
NEAR_CROWN = "maximum near the crown (mm)"  # of the crossings within half a pitch of it
ESTIMATE = "frictionless estimate (mm)"
SUMMARY = {  # results of summary.json by column
    SLIP: "relative_displacement",
    "maximum (mm)": "relative_displacement_max",
    "end force (N)": "end_force",
    "core pressure (MPa)": "core_pressure_max",
    "largest force on the sheave (N)": "yarn_sheave_force_max",
    "friction work (mJ)": "friction_work",
    "crossings on the wrong side": "wrong_side_crossings",
}
CROSSING_FORCE = "largest force at a crossing (N)"


def values_of(scene: Scene, folder: Path) -> dict[str, float]:
    """The numbers of a finished run, by column."""
    values = summary_values(folder, SUMMARY)
    table = read_crossings(folder / FILE)
    near = np.abs(table["z (mm)"] - scene.crown) <= scene.rope.pitch / 2.0
    slid = table["relative displacement (mm)"][near]
    values[NEAR_CROWN] = float(slid[np.isfinite(slid)].max(initial=0.0))
    values[CROSSING_FORCE] = float(table["normal force (N)"].max(initial=0.0))
    values[ESTIMATE] = estimate(scene)
    return values


def estimate(scene: Scene) -> float:
    """Largest relative displacement without friction (geometry/bent_helix.py), mm."""
    assert scene.braid is not None and scene.sheave is not None
    radius = scene.braid.helix_radius
    angle = math.atan(2.0 * math.pi * radius / scene.rope.pitch)
    bent = bend_radius(scene.sheave.diameter, outer_diameter(scene))
    return frictionless_slip(radius, angle, bent)
