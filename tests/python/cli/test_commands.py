"""The commands where all is well, with the computation itself replaced."""

import json
import os
import signal
import sys
from copy import deepcopy
from pathlib import Path
from types import SimpleNamespace

import pytest

import braidx as package
from braidx.output.console import make_console
from braidx.scene import load_scene
from braidx.scene.reference import json_schema, markdown

DEMOS = Path(__file__).parents[3] / "demos"
SMALL = str(DEMOS / "small_rope.toml")

SUMMARY = {
    "scene": "small_rope",
    "converged": True,
    "results": {
        "efficiency": {
            "value": 0.71,
            "unit": "-",
            "reference": 0.699,
            "source": "paper 1",
            "tolerance": 0.1,
            "met": True,
        },
        "friction_work": {
            "value": None,
            "unit": "mJ",
            "reference": None,
            "source": None,
            "tolerance": None,
            "met": None,
        },
    },
    "cost": {
        "phases": {
            "form": {"seconds": 1.5, "increments": 3, "newton_iterations": 9, "linear_solves": 9}
        },
        "peak_memory_MB": 200.0,
        "unknowns": 888,
        "contact_elements": 64,
        "ranks": 1,
        "threads": 2,
    },
}


class NotConverged(RuntimeError):
    pass


@pytest.fixture
def processes(tmp_path, monkeypatch):
    """Stands in for the computation: remembers its calls."""
    monkeypatch.chdir(tmp_path)
    calls = []

    def run(scene, out_dir, resume=False):
        calls.append((scene, out_dir, resume))
        (out_dir / "summary.json").write_text(json.dumps(SUMMARY))
        return SUMMARY

    module = SimpleNamespace(run=run, NotConverged=NotConverged, calls=calls)
    monkeypatch.setitem(sys.modules, "braidx.processes", module)
    monkeypatch.setattr(package, "processes", module, raising=False)
    monkeypatch.setattr("braidx.cli.commands.require_solver", lambda: None)
    monkeypatch.setattr("braidx.cli.commands.agreed", lambda prepare: prepare())
    return module


@pytest.fixture
def invoke(braidx):
    def call(*words, code=0):
        result = braidx(*words)
        assert result.code == code, result
        return result

    return call


def test_run_hands_over_scene_and_folder_and_prints_the_results(invoke, processes):
    result = invoke("run", SMALL, "--set", "contact.friction=0.2")
    ((scene, folder, resume),) = processes.calls
    assert scene == load_scene(SMALL, ["contact.friction=0.2"])
    assert (folder, resume) == (Path("results/small_rope"), False)
    assert load_scene(folder / "scene.toml") == scene
    assert "efficiency" in result.stdout and "0.71" in result.stdout


def test_folders_are_numbered_and_the_newest_is_resumed(invoke, processes):
    for _ in range(3):
        invoke("run", SMALL)
    invoke("run", SMALL, "--resume")
    folders = [folder.name for _, folder, _ in processes.calls]
    assert folders == ["small_rope", "small_rope-2", "small_rope-3", "small_rope-3"]
    assert processes.calls[-1][2] is True


def test_a_run_is_not_overwritten(invoke, processes):
    invoke("run", SMALL, "--out", "mine")
    assert "mine holds a run; add --resume" in invoke("run", SMALL, "--out", "mine", code=2).stderr
    invoke("run", SMALL, "--out", "mine", "--resume")
    assert len(processes.calls) == 2


def test_a_resume_of_another_scene_names_what_differs(invoke, processes):
    invoke("run", SMALL, "--out", "mine")
    words = ("run", SMALL, "--out", "mine", "--resume", "--set")
    (line,) = invoke(*words, "contact.friction=0.3", code=2).stderr.splitlines()
    assert "contact.friction: 0.3 here, 0.1 there" in line
    assert len(processes.calls) == 1
    invoke(*words, "output.every=2")
    invoke("run", "mine/scene.toml", "--out", "mine", "--resume")


def test_a_diverged_run_ends_with_3(invoke, processes):
    def diverge(scene, out_dir, resume=False):
        raise NotConverged("increment 4: yarns 3 and 7 at crossing 5")

    processes.run = diverge
    (line,) = invoke("run", SMALL, "--out", "mine", code=3).stderr.splitlines()
    assert "increment 4: yarns 3 and 7" in line and "mine" in line
    assert Path("mine/scene.toml").exists()


def test_a_missed_expectation_ends_with_1_where_that_is_asked_for(invoke, processes):
    missed = deepcopy(SUMMARY)
    missed["results"]["efficiency"]["met"] = False
    invoke("run", SMALL, "--strict", "--out", "met")
    processes.run = lambda scene, out_dir, resume=False: missed
    invoke("run", SMALL, "--out", "missed")
    (line,) = invoke("run", SMALL, "--strict", "--out", "strict", code=1).stderr.splitlines()
    assert "not as expected: efficiency" in line
    invoke("demo", "--strict", "--accuracy", "5%", "--out", "demo", code=1)


def test_an_interrupted_run_tells_how_to_go_on(invoke, processes):
    def interrupt(scene, out_dir, resume=False):
        os.kill(os.getpid(), signal.SIGTERM)  # as mpirun and batch systems do

    processes.run = interrupt
    (line,) = invoke("run", SMALL, "--out", "mine", code=130).stderr.splitlines()
    assert "--resume" in line and "mine" in line


@pytest.mark.parametrize("option", ["-h", "--help"])
def test_help_lists_ranks_and_the_options_of_the_demo(braidx, option):
    assert braidx(option).stdout.startswith("Usage: braidx [OPTIONS] COMMAND")
    assert "--ranks N" in braidx(option).stdout
    for command in ("run", "demo"):
        text = braidx(command, option).stdout
        for wanted in (f"Usage: braidx {command}", "--ranks", "--accuracy", "--strict"):
            assert wanted in text


def test_the_version_is_told(invoke):
    assert invoke("--version").stdout == f"braidx {package.__version__}\n"


def test_ranks_without_the_launcher_are_refused(invoke):
    assert "mpirun -n 2 braidx" in invoke("run", SMALL, "--ranks", "2", code=2).stderr


@pytest.mark.parametrize("name", ["OMPI_COMM_WORLD_RANK", "PMIX_RANK"])
def test_no_escape_codes_under_mpirun(monkeypatch, name):
    """Open MPI gives its processes a pseudo terminal, and leads what they print there to a file."""
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert make_console().is_terminal
    monkeypatch.setenv(name, "0")
    assert not make_console().is_terminal
    monkeypatch.setenv(name, "1")
    assert make_console().quiet


def test_demo_runs_the_rope_of_the_paper(invoke, processes):
    invoke("demo", "--set", "rope.pitches=1")
    assert processes.calls[0][0].name == "tensile_test"
    assert processes.calls[0][0].rope.pitches == 1


def test_check_prints_what_would_be_computed(invoke):
    text = invoke("check", str(DEMOS / "tensile_test.toml"), "--set", "yarn.model=beam").stdout
    for wanted in (
        "84 (beam)",
        "12 of 1 + 6 yarns",
        "144",
        "20412 as cables, 61236 as beams",
        "one pitch, 28 of 84 yarns",
    ):
        assert wanted in text


def test_check_takes_a_strand(invoke):
    assert "7 (cable)" in invoke("check", str(DEMOS / "twisted_strand.toml")).stdout


def test_check_tells_of_a_rope_that_is_bent(invoke):
    scene = str(DEMOS / "bending_over_sheave.toml")
    text = invoke("check", scene).stdout
    for wanted in (
        "60.00 degrees from the horizontal, 30.00 from the axis",
        "cover factor 0.799",
        "solid, radius 2 mm, st-venant-kirchhoff, 200 MPa",
        "D/d 3.33, flat, fixed",
        "outer diameter 12 mm, yarns overlap by up to 0.39 mm",
        "5220 as cables, 15660 as beams",
        "while formed 2 of 12 yarns, bent all of them",
    ):
        assert wanted in text


@pytest.mark.parametrize(
    ("overrides", "wanted"),
    [
        # 144 layers of elements, 4 x 4 nodes of the square and 12 of the ring, 3 unknowns each
        (["yarn.seeds=12", "yarn.model=solid"], f"about {12 * 145 * 28 * 3} as solids"),
        (
            ["yarn.seeds=12", "yarn.model=solid", "yarn.solid_degree=2"],
            f"about {12 * 289 * 97 * 3} as solids",
        ),
        (["yarn.models.3=cable"], f"{(11 * 9 + 3) * 145} as beams, cables"),
        (["yarn.model=mixed", "yarn.solid_stretch=30"], "as mixed"),
        (["yarn.model=auto"], "those of the models chosen when it runs, auto"),
    ],
)
def test_check_counts_unknowns_of_every_model(invoke, overrides, wanted):
    words = [word for override in overrides for word in ("--set", override)]
    text = invoke("check", str(DEMOS / "bending_over_sheave.toml"), *words).stdout
    assert wanted in " ".join(text.replace("│", " ").split())


def test_show_draws_a_scene(invoke, tmp_path):
    picture = tmp_path / "new" / "start.png"
    assert "start configuration" in invoke("show", SMALL, "--out", str(picture)).stdout
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_show_prints_a_run(invoke, tmp_path):
    (tmp_path / "summary.json").write_text(json.dumps(SUMMARY))
    text = invoke("show", str(tmp_path)).stdout
    for wanted in ("converged", "efficiency", "0.699", "888 unknowns", "form"):
        assert wanted in text


def test_show_refuses_a_broken_summary(invoke, tmp_path):
    (tmp_path / "summary.json").write_text("{}")
    assert "cannot be read" in invoke("show", str(tmp_path), code=2).stderr


def test_schema_as_json_and_as_markdown(invoke):
    assert json.loads(invoke("schema").stdout) == json_schema()
    assert invoke("schema", "--markdown").stdout == markdown()
