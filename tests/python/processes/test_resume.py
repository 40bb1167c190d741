"""kill -9 in the middle of a run, and --resume: the same numbers as without it."""

import os
import signal
import subprocess
import time

import numpy as np
import pytest
import started
from runs import command

from braidx.output import history


def kill_after(folder, rows, **options):
    """Starts a run and kills it as soon as its history has so many rows; the rows it left."""
    path, words = folder / "history.csv", command(folder, **options)
    with subprocess.Popen(
        words,
        env=os.environ | started.ONE_MACHINE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as process:
        while not path.exists() or path.read_text("utf-8").count("\n") <= rows:
            assert process.poll() is None
            time.sleep(0.002)
        os.kill(process.pid, signal.SIGKILL)
        assert process.wait() == -signal.SIGKILL
    return len(history.read(path)["increment"])


@pytest.mark.parametrize("increments_before_the_end", [3, 12])
def test_resumed_run_ends_like_an_uninterrupted_one(
    run, whole_run, tmp_path, increments_before_the_end
):
    whole = whole_run.history
    folder = tmp_path / "killed"
    done = kill_after(folder, len(whole["increment"]) - increments_before_the_end)
    assert done < len(whole["increment"])
    assert not (folder / "summary.json").exists()
    resumed = run(folder, "--resume")
    assert resumed.code == 0, resumed.stderr
    assert resumed.values == pytest.approx(whole_run.values, rel=1e-9)
    rows = resumed.history
    for name in set(whole) - {"seconds", "step"}:
        np.testing.assert_allclose(rows[name], whole[name], rtol=1e-7, atol=1e-12, err_msg=name)
    assert list(rows["step"]) == list(whole["step"])
    cost, expected = resumed.summary["cost"]["phases"], whole_run.summary["cost"]["phases"]
    for phase in expected:
        assert cost[phase]["increments"] == expected[phase]["increments"]


def test_a_finished_run_is_resumed_to_the_same_results(run, whole_run, tmp_path):
    again = run(whole_run.folder, "--resume")
    assert again.code == 0
    assert again.values == whole_run.values
