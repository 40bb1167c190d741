"""Ropes whose ends are held where yarns press on each other, and ropes that come to rest: judged by their folders."""

from __future__ import annotations

from pathlib import Path

from braidx.cli.folder import create_folder
from braidx.output import history
from braidx.scene.build import scene_from_dict
from judge import CONVERGED
from rope_recipes import Recipe
from ropes import computed, judged

QUIET = {"pictures": False, "fields": False, "states": True}


def braid(**yarn: float | str) -> Recipe:
    """Eight strands, 2-over 2-under, drawn among the random ropes."""
    return {
        "rope": {"pitches": 1},
        "braid": {
            "strands_per_direction": [4, 4],
            "motif": "2-over-2-under",
            "helix_radius": 0.7258,
            "angle_from_axis": 26.32,
        },
        "yarn": {"radius": 0.3629, "axial_stiffness": 35400.0, "elements_per_pitch": 32, **yarn},
        "contact": {"friction": 0.336},
        "output": QUIET,
        "steps": [{"kind": "form", "tension": 3.54}, {"kind": "settle", "force": 0.0408}],
    }


def test_held_ends_that_touch_do_not_spread_the_yarns(tmp_path: Path) -> None:
    """Penalties grew for contacts that no penalty can open, to forces of 5.8 kN beside the ends of a rope pulled by
    0.3 kN. It was 9 % too stiff, and residuals of 4 N counted as none.
    """
    recipe = {**braid(), "ends": {"transverse": "fixed"}}
    recipe["steps"].append({"kind": "pull", "to_strain": 0.0013, "strain_increment": 0.0013})
    scene = scene_from_dict(recipe, "rope")
    create_folder(tmp_path / "rope", scene)
    found = judged((0.0,), scene, tmp_path / "rope", computed(scene, tmp_path / "rope"))
    assert found.status == CONVERGED, found.why
    assert found.force_error < 1e-3 and abs(found.energy_error) < 0.01


def test_ropes_at_rest_do_not_creep(tmp_path: Path) -> None:
    """What the stabilisation held back of a rope at rest, a percent of its energy, the next step made good."""
    scene = scene_from_dict(braid(model="beam", axial_stiffness=1585.0), "rope")
    create_folder(tmp_path / "rope", scene)
    assert not computed(scene, tmp_path / "rope")
    rows = history.read(tmp_path / "rope" / "history.csv")
    assert rows["stabilisation residual share (-)"][-1] < 1e-3


def test_penalties_that_are_no_match_for_the_tension_are_raised(tmp_path: Path) -> None:
    """Strands that did not come apart stayed in each other for all of the increments that forming has."""
    recipe = braid()
    recipe["steps"] = [{**recipe["steps"][0], "penalty": 0.1, "gap_reduction": 2.0}]
    scene = scene_from_dict(recipe, "rope")
    create_folder(tmp_path / "rope", scene)
    assert not computed(scene, tmp_path / "rope")
