"""The launcher: its shell parts parse, and it composes the right command (BRAIDX_DRY_RUN)."""

import os
import shlex
import shutil
import signal
import subprocess
import sys
from itertools import dropwhile
from pathlib import Path

import pytest
import started

CHECKOUT = Path(__file__).parents[3]
LAUNCHER = CHECKOUT / "braidx"
PYTHON = shutil.which("python3") or sys.executable
PARTS = sorted((CHECKOUT / "python/braidx/cli/environment").glob("*.sh"))


def launch(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "BRAIDX_DRY_RUN": "1", **variables}
    return subprocess.run([LAUNCHER, *words], env=environment, capture_output=True, text=True)


def command(*words: str) -> list[str]:
    """What the launcher would run, one entry per word, without `env` and the variables it sets."""
    done = launch(*words, BRAIDX_PYTHON=PYTHON)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 1
    got = list(dropwhile(lambda word: word == "env" or "=" in word, shlex.split(done.stdout)))
    return ["python3" if word == PYTHON else word for word in got]


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
    out = shlex.split(launch(*ranks, "demo", **given).stdout)
    assert "OMP_NUM_THREADS=1" in out and "OPENBLAS_NUM_THREADS=1" in out
    out = shlex.split(launch(*ranks, "demo", **(given | {"OPENBLAS_NUM_THREADS": "2"})).stdout)
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
    assert f"PYTHONPATH={CHECKOUT}/python:" in done.stdout.decode()


def test_a_dry_run_prints_what_a_shell_takes() -> None:
    words = ["my rope", "$HOME", "a'b", "", "*"]
    line = launch("shell", "printf", "<%s>", *words, BRAIDX_PYTHON=PYTHON).stdout
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True)
    assert done.stdout == "".join(f"<{word}>" for word in words), done.stderr


def test_a_build_is_of_options_not_of_the_processor(tmp_path: Path) -> None:
    """One folder for every processor; another one for other options."""
    lines = [
        launch("demo", BRAIDX_PYTHON=PYTHON, BRAIDX_CMAKE_ARGS=arguments).stdout
        for arguments in ("", "", "-DBRAIDX_NATIVE=ON")
    ]
    assert lines[0] == lines[1] != lines[2]
    parts = " ".join(path.read_text("utf-8") for path in PARTS)
    assert "BRAIDX_NATIVE" not in parts


def test_a_source_older_than_its_build_is_built_again(tmp_path: Path) -> None:
    """Whatever its time says, as where a cache is kept beside checkouts that are made anew."""
    checkout, build = tmp_path / "checkout", tmp_path / "build"
    for folder in (checkout / "contact_engine", checkout / "tests/cpp", build):
        folder.mkdir(parents=True)
    (checkout / "CMakeLists.txt").touch()
    source = checkout / "contact_engine/forces.cpp"

    def out_of_date() -> bool:
        part = CHECKOUT / "python/braidx/cli/environment/build.sh"
        script = f'. "{part}" && out_of_date all && mv "$build/all.started" "$build/all.built"'
        variables = os.environ | {"checkout": str(checkout), "build": str(build)}
        return subprocess.run(["bash", "-c", script], env=variables).returncode == 0

    source.write_text("first", "utf-8")
    assert out_of_date() and not out_of_date()
    source.write_text("second", "utf-8")
    os.utime(source, (0, 0))
    assert out_of_date() and not out_of_date()
    assert source.stat().st_mtime > 0


def test_a_python_that_is_not_there_is_named(tmp_path: Path) -> None:
    for wrong, told in (("/nope", "there is no such program"), ("false", "is no Python")):
        done = launch("demo", BRAIDX_DRY_RUN="", BRAIDX_PYTHON=wrong, XDG_CACHE_HOME=str(tmp_path))
        assert done.returncode == 2
        assert done.stderr.startswith(f"braidx: BRAIDX_PYTHON={wrong}") and told in done.stderr
        assert len(done.stderr.splitlines()) == 1


def test_a_user_without_uidmap_is_told_of_it(tmp_path: Path) -> None:
    """Who is not root, with mmdebstrap and the right to mount, but without newuidmap (programs are faked)."""
    tools = tmp_path / "tools"
    tools.mkdir()
    for name in ("bash", "dirname", "readlink", "mkdir", "cat", "grep", "flock", "cmp"):
        (tools / name).symlink_to(shutil.which(name) or name)
    for name, script in (("id", "echo 1000"), ("mmdebstrap", ":"), ("unshare", ":")):
        (tools / name).write_text(f"#!/bin/sh\n{script}\n")
        (tools / name).chmod(0o755)
    done = launch(
        "demo",
        BRAIDX_DRY_RUN="",
        BRAIDX_PRIVATE_ROOT="1",
        XDG_CACHE_HOME=str(tmp_path),
        PATH=str(tools),
    )
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert "newuidmap" in line and "apt install uidmap" in line


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


@started.needs_mpirun
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_ranks_end_and_tell_how_to_go_on(tmp_path: Path, number: int) -> None:
    """The line that the launcher would run is one that writes the numbers of its processes and sleeps."""
    launcher = launched_ranks(tmp_path, "echo $$ > $OMPI_COMM_WORLD_RANK; exec sleep inf")
    while len(ranks := [path for path in tmp_path.glob("[01]") if path.read_text()]) < 2:
        assert launcher.poll() is None
    launcher.send_signal(number)
    stderr = launcher.communicate()[1]
    assert launcher.returncode == 130
    assert "--resume" in stderr
    for path in ranks:
        while started.is_running(path.read_text().strip()):
            pass  # a test that would never end is what fails here


@started.needs_mpirun
def test_ranks_end_with_the_code_of_the_program(tmp_path: Path) -> None:
    launcher = launched_ranks(tmp_path, "exit 3")
    launcher.communicate()
    assert launcher.returncode == 3


def launched_ranks(folder: Path, script: str) -> subprocess.Popen[str]:
    """Two ranks of a shell script, started with the launcher's own parts."""
    parts = CHECKOUT / "python/braidx/cli/environment"
    lines = (
        f". {parts}/say.sh; . {parts}/launch.sh; ranks=2 inside=() checkout=. build=.; make_prefix"
    )
    return subprocess.Popen(
        ["bash", "-ec", f'{lines}; launch_ranks "${{prefix[@]}}" bash -c "$1"', "-", script],
        cwd=folder,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=heed_interrupts,
    )


def heed_interrupts() -> None:
    """What runs in the background of a shell ignores interrupts, and so would what it starts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
