"""Results of a run by their names, and their units."""

from __future__ import annotations

from collections.abc import Iterable

from braidx.scene.errors import SceneError, nearest

RESULT_UNITS = {
    "rope_axial_stiffness": "kN",
    "efficiency": "-",
    "outer_diameter_formed": "mm",
    "outer_diameter_loaded": "mm",
    "max_penetration_over_radius": "-",
    "wrong_side_crossings": "count",
    "yarn_stress_mean": "MPa",
    "yarn_stress_std": "MPa",
    "yarn_stress_min": "MPa",
    "yarn_stress_max": "MPa",
    "friction_work": "mJ",
    "stabilisation_work_share": "-",
    "stabilisation_residual_share": "-",
    "relative_displacement": "mm",
    "relative_displacement_max": "mm",
    "crossing_points": "count",
    "yarn_sheave_force_max": "N",
    "sheave_angle": "degrees",
    "core_pressure_max": "MPa",
    "von_mises_max": "MPa",
    "end_force": "N",
    "friction_work_per_cycle": "mJ",
    "cable_share": "-",
    "beam_share": "-",
    "solid_share": "-",
    "temperature_max": "degrees C",
    "temperature_steady_max": "degrees C",
    "heating_power": "W",
}


def check_expected(names: Iterable[str]) -> None:
    """Raises SceneError where a result is expected that no run has."""
    for name in names:
        if name not in RESULT_UNITS:
            raise SceneError(f"expected.{name}", f"no such result; {nearest(name, RESULT_UNITS)}")
