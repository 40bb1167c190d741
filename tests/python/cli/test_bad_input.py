"""Bad input ends with exit code 2 and one line naming input, value and cure; nothing is written."""

import sys
from pathlib import Path

import pytest

from braidx.cli.errors import PAUSE

SMALL = str(Path(__file__).parents[3] / "demos" / "small_rope.toml")
PAPER = str(Path(__file__).parents[3] / "demos" / "tensile_test.toml")


@pytest.fixture
def refuse(braidx, tmp_path, monkeypatch):
    """Call braidx in an empty folder; gives the one line it prints."""
    monkeypatch.chdir(tmp_path)

    def call(*words):
        before = sorted(tmp_path.rglob("*"))
        result = braidx(*words)
        assert result.code == 2, result
        assert result.stdout == ""
        assert sorted(tmp_path.rglob("*")) == before
        (line,) = result.stderr.splitlines()
        assert line.startswith("braidx: ")
        return line

    return call


@pytest.mark.parametrize("command", ["run", "check", "show"])
@pytest.mark.parametrize(
    ("override", "wanted"),
    [
        ("rope.pitches=two", 'rope.pitches = "two": wrong type, give a whole number.'),
        ("rope.pitch=-36", "rope.pitch = -36.0: out of range"),
        ("rope.pitch=0", "rope.pitch = 0.0: out of range"),
        ("strand.yarn_pitch=10", "strand.yarn_pitch = 10.0: has no effect: the strand is one yarn"),
        ("braid.motif=[[1, -1, 1]]", "braid.motif: the 1 x 3 motif does not close"),
        ("yarn.radius=3", "yarn.radius = 3.0: 4 strands of diameter 6 mm per direction jam"),
        ("contact.fricton=0.1", "contact.fricton: unknown key; did you mean 'friction'?"),
        ("yarn.material=hmpe", 'yarn.material = "hmpe": no table [material.hmpe]'),
    ],
)
def test_a_scene_with_a_wrong_value(refuse, command, override, wanted):
    line = refuse(command, SMALL, "--set", override)
    assert wanted in line and SMALL in line


@pytest.mark.parametrize("command", ["run", "check", "show"])
def test_a_missing_file(refuse, command):
    assert "nosuch.toml: no such file" in refuse(command, "nosuch.toml")


def test_a_radius_larger_than_the_strand_allows(refuse):
    assert "at most 0.9 mm" in refuse("run", PAPER, "--set", "yarn.radius=1.5")


def test_a_scene_without_steps(refuse, tmp_path):
    text = Path(SMALL).read_text("utf-8")
    start, end = text.index("[[steps]]"), text.index("[expected")
    (tmp_path / "idle.toml").write_text(text[:start] + text[end:], "utf-8")
    assert "nothing to compute" in refuse("run", "idle.toml")


def test_an_output_folder_that_is_a_file(refuse, tmp_path):
    (tmp_path / "taken").write_text("mine")
    for out in ("taken", "taken/below"):
        assert "cannot write to" in refuse("run", SMALL, "--out", out)


def test_an_output_folder_that_holds_something(refuse, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes").write_text("mine")
    assert "mine is not empty; choose a new folder" in refuse("run", SMALL, "--out", "mine")


def test_a_resume_of_nothing(refuse):
    assert "no run in results/small_rope" in refuse("run", SMALL, "--resume")
    assert "no run in nosuch" in refuse("run", SMALL, "--resume", "--out", "nosuch")


@pytest.mark.parametrize("module", ["dolfinx", "braidx_engine"])
def test_a_missing_solver(refuse, monkeypatch, module):
    monkeypatch.setitem(sys.modules, module, None)
    line = refuse("run", SMALL)
    assert {"dolfinx": "DOLFINx is missing", "braidx_engine": "not built"}[module] in line
    assert "./braidx" in line


def test_a_folder_without_a_run(refuse, tmp_path):
    assert "no summary.json here" in refuse("show", str(tmp_path))


@pytest.mark.parametrize("command", ["test", "shell"])
def test_what_only_the_launcher_does(refuse, command):
    assert f"./braidx {command}" in refuse(command, "-k", "something")


def test_the_first_of_several_processes_speaks_first(refuse, monkeypatch):
    monkeypatch.setenv("OMPI_COMM_WORLD_RANK", "1")
    pauses: list[float] = []
    monkeypatch.setattr("time.sleep", pauses.append)
    refuse("check", "nosuch.toml")
    assert pauses == [PAUSE]
