"""The launcher: its shell parts parse, and it composes the right command (BRAIDX_DRY_RUN)."""

import os
import subprocess
from itertools import dropwhile
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).parents[3]
LAUNCHER = CHECKOUT / "braidx"
PARTS = sorted((CHECKOUT / "python/braidx/cli/environment").glob("*.sh"))


def launch(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "BRAIDX_DRY_RUN": "1", **variables}
    return subprocess.run(
        [LAUNCHER, *words], env=environment, capture_output=True, text=True, timeout=20
    )


def command(*words: str) -> list[str]:
    """What the launcher would run, one entry per word, without `env` and the variables it sets."""
    done = launch(*words)
    assert done.returncode == 0, done.stderr
    return list(dropwhile(lambda word: "=" in word, done.stdout.split("\n")[1:-1]))


@pytest.mark.parametrize("script", [LAUNCHER, *PARTS], ids=lambda path: path.name)
def test_scripts_parse(script: Path) -> None:
    subprocess.run(["bash", "-n", script], check=True)


def test_words_are_handed_over_untouched() -> None:
    words = ["run", "my rope.toml", "--out", "a  b", "$HOME", ""]
    assert command(*words) == ["python3", "-m", "braidx", *words]


@pytest.mark.parametrize("words", [["--ranks", "2", "run", "x"], ["run", "--ranks=2", "x"]])
def test_ranks_become_mpirun_anywhere(words: list[str]) -> None:
    got = command(*words)
    assert got[:3] == ["mpirun", "-n", "2"]
    assert got[-5:] == ["python3", "-m", "braidx", "run", "x"]


@pytest.mark.parametrize("ranks", [[], ["--ranks", "64"]])
def test_one_thread_per_process_unless_told_otherwise(ranks: list[str]) -> None:
    given = {"OMP_NUM_THREADS": "", "OPENBLAS_NUM_THREADS": ""}
    out = launch(*ranks, "demo", **given).stdout.splitlines()
    assert "OMP_NUM_THREADS=1" in out and "OPENBLAS_NUM_THREADS=1" in out
    out = launch(*ranks, "demo", **(given | {"OPENBLAS_NUM_THREADS": "2"})).stdout.splitlines()
    assert "OPENBLAS_NUM_THREADS=2" in out


@pytest.mark.parametrize("words", [["--ranks"], ["--ranks", "0"], ["run", "--ranks", "two"]])
def test_bad_ranks_name_the_input(words: list[str]) -> None:
    done = launch(*words)
    assert done.returncode == 2
    assert done.stderr.startswith("braidx: --ranks")
    assert len(done.stderr.splitlines()) == 1


def test_shell_keeps_its_own_options() -> None:
    assert command("shell", "echo", "--ranks", "3") == ["echo", "--ranks", "3"]


@pytest.mark.parametrize(("given", "papers"), [("--verification", True), ("--studies", False)])
def test_ropes_of_the_papers_are_part_of_the_verification_only(given: str, papers: bool) -> None:
    words = command("test", given, "-k", "rope")
    assert words[:4] == ["python3", "-m", "pytest", f"tests/{given[2:]}"]
    assert ("--papers" in words) == papers and words[-2:] == ["-k", "rope"]


def test_runs_from_any_folder_and_through_a_link(tmp_path: Path) -> None:
    link = tmp_path / "braidx"
    link.symlink_to(LAUNCHER)
    environment = {**os.environ, "BRAIDX_DRY_RUN": "1", "PYTHONPATH": ""}
    done = subprocess.run([link, "demo"], cwd=tmp_path, env=environment, capture_output=True)
    assert f"PYTHONPATH={CHECKOUT}/python:BUILD" in done.stdout.decode().splitlines()


def test_a_python_without_dolfinx_is_named(tmp_path: Path) -> None:
    python = tmp_path / "python3"
    python.write_text("#!/bin/sh\necho 'DOLFINx>=0.9'\n")
    python.chmod(0o755)
    done = launch(
        "demo", BRAIDX_DRY_RUN="", BRAIDX_PYTHON=str(python), XDG_CACHE_HOME=str(tmp_path)
    )
    assert done.returncode == 2
    assert "lacks: DOLFINx>=0.9" in done.stderr


@pytest.mark.parametrize("folder", ["/", "/usr", "/usr/share"])
def test_no_folder_hides_the_private_root(tmp_path: Path, folder: str) -> None:
    """Started in a folder that the root has too, the root's own stays in sight (mount is faked)."""
    tools, root = tmp_path / "tools", tmp_path / "root"
    tools.mkdir()
    (root / "usr/share/doc").mkdir(parents=True)
    (tools / "mount").write_text('#!/bin/sh\necho "$2"\n')
    (tools / "mount").chmod(0o755)
    environment = {
        **os.environ,
        "PATH": f"{tools}:{os.environ['PATH']}",
        "BRAIDX_CHECKOUT": str(CHECKOUT),
        "BRAIDX_CACHE": str(tmp_path),
        "BRAIDX_UID": "0",
    }
    enter = CHECKOUT / "python/braidx/cli/environment/enter.sh"
    done = subprocess.run(
        ["bash", enter, root, "true"], cwd=folder, env=environment, capture_output=True
    )
    shown = done.stdout.decode().splitlines()
    assert "/proc" in shown and folder not in shown
