"""The scripts of the studies: their ropes can be built, one runs from end to end, failures do not stop the others."""

from __future__ import annotations

import csv
import importlib
import json
import sys
from pathlib import Path

import pytest
import started

from braidx.geometry import build_rope

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.append(str(STUDIES))

import bent_values  # noqa: E402
import study_runs  # noqa: E402
from bent_values import ESTIMATE, SLIP  # noqa: E402
from study import BENDING, QUICK, Case, Statement, Study, main  # noqa: E402
from study_report import ERROR, draw, errors, markdown, table  # noqa: E402
from study_runs import Outcome, case_scene, folder_name, scene_of  # noqa: E402
from summaries import SECONDS  # noqa: E402

SCRIPTS = (
    "diameter_ratio",
    "braiding_angle",
    "yarn_count",
    "yarn_radius",
    "mesh_sensitivity",
    "models",
    "pitch_length",
    "friction_coefficient",
    "bedding_in",
    "sensitivity",
)


def test_every_script_is_tested():
    scripts = {path.stem for path in STUDIES.glob("*.py") if "study(" in path.read_text("utf-8")}
    assert set(SCRIPTS) == {name for name in scripts if not name.startswith(("study", "test_"))}


@pytest.mark.parametrize("quick", [False, True], ids=["whole", "quick"])
@pytest.mark.parametrize("name", SCRIPTS)
def test_ropes_of_a_study(name, quick):
    study = importlib.import_module(name).study(quick)
    assert study.name == name and len({case.label for case in study.cases}) == len(study.cases)
    assert study.reference in (None, *(case.label for case in study.cases))
    scenes = [scene_of(study, case) for case in study.cases]
    for scene in scenes:
        build_rope(scene)
    folders = {folder_name(scene) for scene in scenes}
    assert len(folders) == len(scenes)
    if study.demo == BENDING and not quick and name != "mesh_sensitivity":
        assert all(173.0 < scene.length < 177.0 for scene in scenes)


def test_a_rope_of_two_studies_is_computed_once():
    whole = case_scene([])
    assert folder_name(whole) == folder_name(case_scene(["sheave.diameter=40", "yarn.model=beam"]))
    assert folder_name(whole) == folder_name(case_scene(["output.pictures=true"]))
    assert folder_name(whole) != folder_name(case_scene(["contact.friction=0.1"]))


def test_quick_study_from_end_to_end(tmp_path):
    script = STUDIES / "diameter_ratio.py"
    words = [sys.executable, str(script), "--quick", "--out", str(tmp_path)]
    done = started.run(*words)
    assert done.returncode == 0, done.stdout + done.stderr
    with (tmp_path / "diameter_ratio.csv").open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["state"] for row in rows] == ["converged", "converged"]
    assert float(rows[0][SLIP]) > 0.0 and float(rows[0][SECONDS]) > 0.0
    # Twice the sheave: (20 + 5.6) / (40 + 5.6) of the estimate.
    ratio = float(rows[1][ESTIMATE]) / float(rows[0][ESTIMATE])
    assert ratio == pytest.approx(25.6 / 45.6, rel=1e-3)
    assert "slightly over 0.7 mm" in (tmp_path / "diameter_ratio.md").read_text("utf-8")
    assert (tmp_path / "diameter_ratio.png").read_bytes().startswith(b"\x89PNG")
    # What has been computed is not computed again, and a table of one case has one row.
    before = {path: path.stat().st_mtime_ns for path in tmp_path.glob("runs/*/summary.json")}
    again = started.run(*words, "--only", "3.57")
    assert again.returncode == 0, again.stderr
    assert {path: path.stat().st_mtime_ns for path in before} == before and len(before) == 2
    assert again.stdout.count("converged") == 1


def test_a_run_that_failed_or_was_interrupted_is_not_finished(tmp_path):
    scene = case_scene(QUICK)
    assert not study_runs.is_finished(tmp_path, scene)
    (tmp_path / "scene.toml").write_text(study_runs.to_toml(scene), "utf-8")
    (tmp_path / study_runs.FILE).touch()
    for converged in (False, True):
        text = json.dumps({"converged": converged})
        (tmp_path / "summary.json").write_text(text, "utf-8")
        assert study_runs.is_finished(tmp_path, scene) is converged
    other = case_scene([*QUICK, "contact.friction=0.1"])
    assert not study_runs.is_finished(tmp_path, other)


def test_a_case_that_fails_is_in_the_table_and_the_others_go_on(tmp_path, monkeypatch, capsys):
    def run(scene, folder):
        (folder / "runs").parent.mkdir(parents=True, exist_ok=True)
        return "not converged: increment 3" if scene.contact.friction == 0.3 else ""

    monkeypatch.setattr(study_runs, "_run", run)
    monkeypatch.setattr(study_runs, "values_of", lambda scene, folder: values(0.5))
    cases = tuple(Case(f, float(f), (f"contact.friction={f}",)) for f in ("0.1", "0.3", "-1"))
    study = Study("friction", "friction", "friction (-)", cases, base=QUICK)
    assert main(lambda quick: study, ["--out", str(tmp_path)]) == 1
    with (tmp_path / "friction.csv").open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert rows[0]["state"] == "converged" and float(rows[0][SLIP]) == 0.5
    assert rows[1]["state"] == "not converged: increment 3" and rows[1][SLIP] == ""
    assert rows[2]["state"].startswith("bad input: contact.friction = -1")
    assert "friction, 0.3: not converged" in capsys.readouterr().out


def values(slip, seconds=1.0):
    numbers = {name: 1.0 for name in (*bent_values.SUMMARY, bent_values.NEAR_CROWN)}
    numbers |= {bent_values.CROSSING_FORCE: 3.0, ESTIMATE: 1.5, SLIP: slip, SECONDS: seconds}
    return numbers


def test_errors_are_counted_from_the_reference(tmp_path):
    cases = tuple(Case(name, float(i)) for i, name in enumerate(("coarse", "fine", "finest")))
    said = Statement("paper 2: so much", 0.4, (0.0, 1.0))
    study = Study("m", "meshes", "mesh", cases, (said,), named=True, reference="finest")
    outcomes = [Outcome(case, values(s)) for case, s in zip(cases, (0.6, 0.44, 0.4))]
    assert errors(study, outcomes) == pytest.approx({"coarse": 50.0, "fine": 10.0})
    rows = table(study, outcomes)
    at = rows[0].index(ERROR)
    assert [row[at] for row in rows[1:]] == ["50", "10", ""]
    assert "Paper 2: so much." in markdown(study, rows)
    assert draw(study, outcomes, tmp_path / "m.png").stat().st_size > 10000
    lost = [*outcomes[:2], Outcome(cases[2], failure="not converged")]
    assert errors(study, lost) == {}
    assert draw(study, lost, tmp_path / "lost.png").stat().st_size > 10000
