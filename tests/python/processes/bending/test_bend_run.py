"""Runs of the smallest rope that is bent, as a user starts them."""

from pathlib import Path

import numpy as np
import pytest
from test_resume import kill_after

from braidx.processes.bending.bender import PAIRED

SCENE = Path(__file__).parent / "small_bend.toml"


@pytest.fixture(scope="module")
def bent(run, tmp_path_factory):
    finished = run(tmp_path_factory.mktemp("bent") / "whole", scene=SCENE)
    assert finished.code == 0, finished.stderr
    return finished


def test_the_rope_is_bent_and_straightened(bent):
    travel = bent.history["travel (mm)"]
    assert np.nanmax(travel) == pytest.approx(4.0)
    assert travel[-1] == pytest.approx(0.0, abs=1e-9)
    assert bent.summary["converged"]


def test_results_are_those_of_the_bent_rope(bent):
    values = bent.values
    assert 0.1 < values["relative_displacement"] <= values["relative_displacement_max"]
    assert (
        values["crossing_points"] == 2 * 6 * 3
    )  # two pitches, six crossings of each of three yarns
    assert values["wrong_side_crossings"] == 0
    assert values["end_force"] > 0 and values["core_pressure_max"] > 0
    assert 0 < values["friction_work_per_cycle"] == pytest.approx(values["friction_work"], rel=0.05)
    assert values["max_penetration_over_radius"] <= 0.016
    assert values["stabilisation_residual_share"] < 0.02


def test_solid_yarns_about_the_crown_slide_as_beams_do(run, bent, tmp_path):
    words = ("yarn.model=mixed", "yarn.seeds=8", "yarn.solid_stretch=14")
    mixed = run(tmp_path / "mixed", *(part for w in words for part in ("--set", w)), scene=SCENE)
    assert mixed.code == 0, mixed.stderr
    assert mixed.values["solid_share"] > 0.1 and mixed.values["von_mises_max"] > 0
    assert mixed.values["wrong_side_crossings"] == 0
    slide = bent.values["relative_displacement_max"]
    assert mixed.values["relative_displacement_max"] == pytest.approx(slide, rel=0.1)


def test_two_processes_bend_as_one(run, bent, tmp_path):
    two = run(tmp_path / "two", scene=SCENE, ranks=2)
    assert two.code == 0, two.stderr
    # Two processes sum in no fixed order. Contact updates stop at a residual of PAIRED, some of them one earlier or
    # later then: the work of friction, which sums over all increments, shows that.
    for name, rel in (
        ("relative_displacement", 1e-3),
        ("end_force", 1e-3),
        ("friction_work", 2 * PAIRED),
    ):
        assert two.values[name] == pytest.approx(bent.values[name], rel=rel), name


def test_a_bend_that_was_killed_goes_on(run, bent, tmp_path):
    folder, rows = tmp_path / "killed", len(bent.history["increment"])
    assert kill_after(folder, rows - 3, scene=SCENE) < rows
    resumed = run(folder, "--resume", scene=SCENE)
    assert resumed.code == 0, resumed.stderr
    assert resumed.values == pytest.approx(bent.values, rel=1e-6, abs=1e-9)


def test_what_the_stabilisation_holds_is_no_result(run, tmp_path):
    words = ["solver.viscosity=3e3", "steps.bend.travel=1", "steps.bend.increments=1"]
    held = run(tmp_path / "held", *(part for w in words for part in ("--set", w)), scene=SCENE)
    assert held.code == 3 and "the stabilisation still did" in held.stderr
    assert not held.summary["converged"]
    assert held.history["travel (mm)"][-1] == pytest.approx(0.0)  # it has kept all of the way
