"""Results of a run: which numbers are taken from which state."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

import numpy as np

from ..geometry import Rope
from ..output.measures import linear_fit, outer_diameter, yarn_stress
from ..output.snapshot import Snapshot
from ..scene import Pull, Scene
from ..scene.results import RESULT_UNITS

# Of results of a whole run: which states they are of.
OF_THE_RUN = {
    "rope_axial_stiffness": "first loading, from 50 to 100 % of the largest force",
    "efficiency": "first loading, from 50 to 100 % of the largest force",
    "max_penetration_over_radius": "largest of all states after forming",
    "friction_work": "end of the run, counted from its start",
    "friction_work_per_cycle": "last whole cycle",
    "stabilisation_work_share": "end of the run, counted from the formed rope",
    "stabilisation_residual_share": "largest of all states reported",
}

ON_THE_WAY = (
    "form",
    "settle",
    "bend",
    "run_over",
    "straighten",
    "bend_cycles",
)  # steps whose end counts

FIRST_PULL = tuple(n for n in RESULT_UNITS if n.startswith("yarn_stress") or n.endswith("_loaded"))


def state_results(picture: Snapshot, wrong: int, forming: bool) -> dict[str, float]:
    """Results of a state worth a picture; stresses and loaded diameter are those of the first pull."""
    name, results = picture.name, {"wrong_side_crossings": float(wrong)}
    if forming and name == "formed":
        results["outer_diameter_formed"] = outer_diameter(picture)
    if picture.is_pulled:
        stress = yarn_stress(picture)
        results |= {
            "outer_diameter_loaded": outer_diameter(picture),
            "yarn_stress_mean": stress.mean,
            "yarn_stress_std": stress.std,
            "yarn_stress_min": stress.min,
            "yarn_stress_max": stress.max,
        }
    return results


def final_results(scene: Scene, rope: Rope, rows: Mapping[str, np.ndarray]) -> dict[str, float]:
    """Results of the whole history: stiffness on the linear part, deepest penetration, stabilisation.

    Forming is a way and not a result: of it only the last increment counts; coming to rest likewise.
    """
    results: dict[str, float] = {}
    step = np.array([str(s) for s in rows["step"]])
    for name, column, ways in (
        ("max_penetration_over_radius", "max penetration / radius (-)", ("form",)),
        ("stabilisation_residual_share", "stabilisation residual share (-)", ON_THE_WAY),
    ):
        reported = np.ones(len(step), dtype=bool)
        for way in ways:
            passed = np.flatnonzero(np.char.endswith(step, way))
            reported[passed[:-1]] = False
        if reported.any():
            results[name] = float(rows[column][reported].astype(float).max())
    if len(step):
        results["stabilisation_work_share"] = float(rows["stabilisation work share (-)"][-1])
    pulled = np.array(
        [isinstance(scene.steps[int(s.split()[0]) - 1], Pull) for s in step], dtype=bool
    )
    if pulled.sum() >= 2 and rows["force (kN)"][pulled].max() > 0:
        strain = rows["rope strain (-)"][pulled].astype(float)
        force = rows["force (kN)"][pulled].astype(float)
        with suppress(ValueError):  # a pull that ended early may have no linear part
            stiffness = linear_fit(strain, force).stiffness
            results["rope_axial_stiffness"] = stiffness
            results["efficiency"] = stiffness * 1e3 / (rope.num_yarns * scene.yarn.axial_stiffness)
    return results
