"""What tests start ends with them."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import started

SLEEP = 'echo $$ > "$1/$OMPI_COMM_WORLD_RANK"; exec sleep inf'


@started.needs_mpirun
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_ranks_end_with_the_test_that_started_them(tmp_path: Path, number: int) -> None:
    # What runs in the background of a shell ignores interrupts, and so would what it starts.
    heeds = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    run = f"import started; started.run('bash', '-c', {SLEEP!r}, '-', {str(tmp_path)!r}, ranks=2)"
    path = os.pathsep.join([str(Path(started.__file__).parent), os.environ.get("PYTHONPATH", "")])
    test = subprocess.Popen(
        [sys.executable, "-c", f"{heeds}; {run}"],
        env=os.environ | {"PYTHONPATH": path},
        stderr=subprocess.DEVNULL,
    )
    while len(ranks := [path for path in tmp_path.iterdir() if path.read_text()]) < 2:
        assert test.poll() is None
    test.send_signal(number)
    assert test.wait() == -number
    for rank in ranks:
        while started.is_running(rank.read_text().strip()):
            pass  # a rank that stays on is what fails here


def test_outcome_is_told() -> None:
    done = started.run("bash", "-c", 'echo "$NAME"; echo wrong >&2; exit 3', NAME="a b")
    assert (done.returncode, done.stdout, done.stderr) == (3, "a b\n", "wrong\n")
