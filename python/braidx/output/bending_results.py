"""The results of a bent rope for summary.json."""

from __future__ import annotations

import numpy as np

from braidx.output.bending_measures import (
    core_pressure_max,
    crown_of,
    section_ratios,
    sheave_force_total,
    von_mises_max,
    yarn_sheave_force_max,
)
from braidx.output.interlacing import relative_displacement
from braidx.output.measures import layers
from braidx.output.snapshot import Snapshot

BENDING_RESULTS = {
    "crossing_points": "count",
    "relative_displacement": "mm",
    "relative_displacement_max": "mm",
    "yarn_sheave_force_max": "N",
    "sheave_force_total": "N",
    "core_pressure_max": "MPa",
    "von_mises_max": "MPa",
    "section_ratio_min": "-",
}


def bending_results(reference: Snapshot, bent: Snapshot) -> dict[str, float]:
    """Values of BENDING_RESULTS; what a snapshot has no data for is left out.

    Args:
        reference: The straight rope.
        bent: The same yarns and nodes now.
    """
    crown = crown_of(bent)
    slip = relative_displacement(
        reference.centre_lines, bent.centre_lines, reference.radius, layers(reference)
    )
    results = {
        "crossing_points": float(len(slip.reference)),
        "relative_displacement": slip.mean_at_crown(crown),
        "relative_displacement_max": slip.maximum(),
        "von_mises_max": von_mises_max(bent),
    }
    if bent.contacts is not None:
        results["yarn_sheave_force_max"] = yarn_sheave_force_max(bent)
        results["sheave_force_total"] = sheave_force_total(bent)
        results["core_pressure_max"] = core_pressure_max(bent)
    ratios = section_ratios(bent, crown)
    if np.isfinite(ratios).any():
        results["section_ratio_min"] = float(np.nanmin(ratios))
    return {name: value for name, value in results.items() if np.isfinite(value)}
