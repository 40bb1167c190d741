"""What the stabilisation of a rope holds on the way, it lets go of in the end."""

from __future__ import annotations

from pathlib import Path

import pytest

from braidx.cli.folder import create_folder
from braidx.output import history
from braidx.scene.build import scene_from_dict
from rope_recipes import Recipe
from ropes import computed


def loose_braid(viscosity: float) -> Recipe:
    """Loose bundles of filaments, drawn among the first random ropes, and hardly loaded.

    Args:
        viscosity: Of directors, N mm per radian.
    """
    return {
        "rope": {"pitches": 1},
        "braid": {
            "strands_per_direction": [4, 4],
            "motif": "2-over-2-under",
            "helix_radius": 1.451,
            "angle_from_axis": 30.8,
        },
        "yarn": {
            "radius": 0.6584,
            "axial_stiffness": 72480.0,
            "model": "beam",
            "bundle_factor": 0.00166,
            "elements_per_pitch": 28,
        },
        "contact": {"friction": 0.024},
        "solver": {"director_viscosity": viscosity},
        "output": {"pictures": False, "fields": False},
        "steps": [
            {"kind": "form", "tension": 7.25},
            {"kind": "settle", "force": 0.0735},
            {"kind": "pull", "to_strain": 0.005618, "strain_increment": 0.00156},
        ],
    }


def force(viscosity: float, folder: Path) -> float:
    """On the rope at the end, kN."""
    scene = scene_from_dict(loose_braid(viscosity), "rope")
    create_folder(folder, scene)
    assert not computed(scene, folder)
    return float(history.read(folder / "history.csv")["force (kN)"][-1])


def test_forces_do_not_depend_on_the_viscosity_of_directors(tmp_path: Path) -> None:
    """It let go of them four times and took what was left: with 500 N mm the force was 18 % too large."""
    strong = force(500.0, tmp_path / "strong")
    assert strong == pytest.approx(force(5.0, tmp_path / "weak"), rel=0.01)
