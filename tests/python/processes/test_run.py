"""A run of the small rope: what it finds, on how many processes, and what it leaves when it fails."""

import re
from pathlib import Path

import numpy as np
import pytest
import started

from braidx.output import snapshot
from braidx.processes import state
from braidx.scene import load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


def test_expected_values_are_met(whole_run):
    summary = whole_run.summary
    assert summary["converged"]
    scene = load_scene(whole_run.folder / "scene.toml")
    assert set(scene.expected) <= set(summary["results"])
    missed = {name: r for name, r in summary["results"].items() if r["met"] is False}
    assert not missed


def test_history_has_a_row_per_increment(whole_run):
    rows, phases = whole_run.history, whole_run.summary["cost"]["phases"]
    count = sum(phase["increments"] for phase in phases.values())
    np.testing.assert_array_equal(rows["increment"], np.arange(1, count + 1))
    newton = sum(phase["newton_iterations"] for phase in phases.values())
    assert rows["Newton iterations"].sum() == newton
    steps = [str(step) for step in rows["step"]]
    assert list(dict.fromkeys(steps)) == ["1 form", "2 settle", "3 pull"]
    assert rows["force (kN)"][-1] == pytest.approx(5.0, rel=5e-3)
    work = rows["friction work (mJ)"]
    assert np.all(np.diff(work) >= 0)
    formed = np.flatnonzero(rows["step"] == "1 form")[-1]
    assert work[formed] > 0  # friction acts once the yarns of the formed rope are in place


def test_results_name_the_state_that_they_are_of(whole_run):
    results = whole_run.summary["results"]
    assert all(result["state"] for result in results.values())
    assert results["outer_diameter_formed"]["state"].startswith("formed, ")
    for name in ("yarn_stress_mean", "outer_diameter_loaded"):
        assert float(results[name]["state"].removesuffix(" kN")) == pytest.approx(5.0, rel=5e-3)
    assert [name for name in results if "diameter" in name] == [
        "outer_diameter_formed",
        "outer_diameter_loaded",
    ]


def test_friction_work_is_at_least_that_of_the_contacts_there_are(whole_run):
    """Both count from the start of the run; contacts that have ended are in the sum of the history alone."""
    last = max((whole_run.folder / "snapshots").iterdir())
    present = float(snapshot.load(last).contacts.work.sum())
    total = whole_run.values["friction_work"]
    assert 0.0 < present <= total * (1.0 + 1e-9)


def test_the_last_state_is_kept(whole_run):
    last = state.load(whole_run.folder)
    assert last is not None and last.increment == whole_run.history["increment"][-1]
    assert last.model == "cable" and last.step == 3
    assert {p.suffix for p in (whole_run.folder / "snapshots").iterdir()} == {".npz"}


def test_every_state_is_kept_where_asked_for(run, tmp_path):
    every = run(tmp_path / "every", "--set", "output.states=true")
    rows = len(every.history["increment"])
    kept = sorted((every.folder / "states").iterdir())
    assert [int(path.name[:5]) for path in kept] == list(range(1, rows + 1))
    assert snapshot.load(kept[-1]).contacts is not None


@started.needs_mpirun
def test_two_processes_find_what_one_does(run, whole_run, tmp_path):
    parallel = run(tmp_path / "parallel", ranks=2)
    assert parallel.code == 0, parallel.stderr
    assert parallel.summary["cost"]["ranks"] == 2
    one, two = whole_run.values, parallel.values
    assert two["wrong_side_crossings"] == one["wrong_side_crossings"] == 0
    for name in ("rope_axial_stiffness", "outer_diameter_loaded", "yarn_stress_mean"):
        assert two[name] == pytest.approx(one[name], rel=1e-6)


@pytest.mark.parametrize("pulled", ["cable", "beam"])
def test_beams_find_the_shape_that_cables_do(run, whole_run, tmp_path, pulled):
    scene = tmp_path / "beams.toml"
    formed = 'kind = "form"\nmodel = "beam"'
    scene.write_text(SMALL.read_text("utf-8").replace('kind = "form"', formed), "utf-8")
    beams = run(tmp_path / "out", "--set", f"yarn.model={pulled}", scene=scene)
    assert beams.code == 0, beams.stderr
    name = "outer_diameter_formed"
    assert beams.values[name] == pytest.approx(whole_run.values[name], rel=0.005)
    assert beams.values["wrong_side_crossings"] == 0
    if pulled == "cable":
        stiffness = "rope_axial_stiffness"
        assert beams.values[stiffness] == pytest.approx(whole_run.values[stiffness], rel=0.01)


def test_one_pitch_stands_for_all(run, tmp_path):
    """A rope of two pitches, solved as one pitch and as a whole."""
    two = ["--set", "rope.pitches=2"]
    one = run(tmp_path / "one", *two)
    whole = run(tmp_path / "whole", *two, "--set", "solver.symmetry=false")
    assert whole.summary["cost"]["unknowns"] > 4 * one.summary["cost"]["unknowns"]
    for name in ("rope_axial_stiffness", "outer_diameter_formed", "outer_diameter_loaded"):
        assert one.values[name] == pytest.approx(whole.values[name], rel=1e-3)
    for name in ("yarn_stress_mean", "yarn_stress_min", "yarn_stress_max"):
        assert one.values[name] == pytest.approx(whole.values[name], rel=5e-3)
    last = max((one.folder / "snapshots").iterdir())
    lines = snapshot.load(last).centre_lines
    ends = np.array([line[[0, -1], 2] for line in lines])
    assert np.ptp(ends, axis=1) == pytest.approx(2 * 36.0, rel=0.02)


def test_a_diverged_run_keeps_what_it_had(run, tmp_path):
    """Forming ends well; then beams are pulled by more than single iterations find an equilibrium for."""
    scene = tmp_path / "pushed.toml"
    pushed = "to_strain = 0.4\nstrain_increment = 0.09"
    scene.write_text(SMALL.read_text("utf-8").replace("to_force = 5.0", pushed), "utf-8")
    hasty = ["yarn.model=beam", "solver.max_cuts=0", "solver.max_iterations=2"]
    options = [word for setting in hasty for word in ("--set", setting)]
    failed = run(tmp_path / "failed", *options, scene=scene)
    assert failed.code == 3
    message = failed.stderr.splitlines()[-1]
    assert re.match(r"braidx: increment \d+: no equilibrium at rope strain 0\.", message)
    assert (
        re.search(r"between yarns (\d+-\d+, )*\d+-\d+", message) and str(failed.folder) in message
    )
    assert failed.summary["converged"] is False
    assert failed.values["wrong_side_crossings"] == 0
    last = state.load(failed.folder)
    assert last is not None and last.step == 2
    assert last.increment == failed.history["increment"][-1] > 0
    again = run(failed.folder, "--resume", *options, scene=scene)
    assert again.code == 3
