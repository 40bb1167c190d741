"""Runs of the smallest braid that several tests look at."""

import subprocess

import pytest
from runs import Run, command, environment


@pytest.fixture(scope="session")
def run():
    """Runs the small rope to its end; gives the Run."""

    def start(folder, *words, **options):
        done = subprocess.run(
            command(folder, *words, **options),
            env=environment(),
            capture_output=True,
            text=True,
            timeout=300,
        )
        return Run(folder, done.returncode, done.stderr)

    return start


@pytest.fixture(scope="session")
def whole_run(run, tmp_path_factory):
    """The small rope, computed without interruption."""
    finished = run(tmp_path_factory.mktemp("small") / "whole")
    assert finished.code == 0, finished.stderr
    return finished
