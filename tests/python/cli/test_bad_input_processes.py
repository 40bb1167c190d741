"""Bad input to the program as it is started: exit code 2, one line, no traceback, nothing overwritten."""

import os
import sys
from pathlib import Path

import pytest
import started

from braidx.scene import load_scene, to_toml

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


def start(folder, *words, ranks=0, **variables):
    """Starts the program in a folder; exit code, and its own lines on stderr."""
    path = os.pathsep.join(filter(None, [variables.pop("first", ""), os.environ.get("PYTHONPATH")]))
    program = (sys.executable, "-m", "braidx")
    done = started.run(*program, *words, ranks=ranks, folder=folder, PYTHONPATH=path)
    assert "Traceback" not in done.stderr
    return done.returncode, [line for line in done.stderr.splitlines() if "braidx:" in line]


@pytest.fixture
def work(tmp_path):
    """An empty folder to work in."""
    (tmp_path / "work").mkdir()
    return tmp_path / "work"


@pytest.mark.parametrize(
    "module, wanted", [("dolfinx", "DOLFINx is missing"), ("braidx_engine", "not built")]
)
def test_without_solver(work, tmp_path, module, wanted):
    broken = tmp_path / "broken"
    broken.mkdir()
    (broken / f"{module}.py").write_text(f"raise ModuleNotFoundError(name={module!r})")
    code, (line,) = start(work, "run", str(SMALL), first=str(broken))
    assert code == 2 and wanted in line and "./braidx" in line
    assert not list(work.iterdir())


def test_a_scene_can_be_checked_without_solver(work, tmp_path):
    broken = tmp_path / "broken"
    broken.mkdir()
    for module in ("dolfinx", "petsc4py", "mpi4py", "braidx_engine"):
        (broken / f"{module}.py").write_text(f"raise ModuleNotFoundError(name={module!r})")
    assert start(work, "check", str(SMALL), first=str(broken)) == (0, [])


@started.needs_mpirun
def test_several_processes_speak_once(work):
    code, (line,) = start(work, "run", str(SMALL), "--set", "yarn.radius=-1", ranks=2)
    assert code == 2 and "yarn.radius = -1.0: out of range" in line
    assert not list(work.iterdir())


@pytest.mark.skipif(os.geteuid() == 0, reason="the superuser may write anywhere")
def test_an_unwritable_folder(work):
    work.chmod(0o555)
    code, (line,) = start(work, "run", str(SMALL), "--out", "new")
    assert code == 2 and "no permission to write" in line


def test_an_unfinished_run_is_not_overwritten(work):
    """Nor is one that was stopped: what the folder holds stays, and the cure is named."""
    folder = work / "mine"
    folder.mkdir()
    (folder / "scene.toml").write_text(to_toml(load_scene(SMALL)), "utf-8")
    (folder / "history.csv").write_text("increment\n1\n")
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    code, (line,) = start(work, "run", str(SMALL), "--out", "mine")
    assert code == 2 and "add --resume" in line
    code, (line,) = start(
        work, "run", str(SMALL), "--out", "mine", "--resume", "--set", "yarn.radius=0.8"
    )
    assert code == 2 and "another scene" in line and "yarn.radius" in line
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_damaged_checkpoint_is_told(work):
    folder = work / "mine"
    folder.mkdir()
    (folder / "scene.toml").write_text(to_toml(load_scene(SMALL)), "utf-8")
    (folder / "checkpoint.npz").write_bytes(b"not a checkpoint")
    code, lines = start(work, "run", str(SMALL), "--out", "mine", "--resume")
    assert code == 2 and "checkpoint" in lines[0]
