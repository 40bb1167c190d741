"""Runs of the smallest braid that several tests look at."""

import pytest
import started
from runs import Run, command


@pytest.fixture(scope="session")
def run():
    """Runs the small rope to its end; gives the Run."""

    def start(folder, *words, ranks=0, **options):
        done = started.run(*command(folder, *words, **options), ranks=ranks)
        return Run(folder, done.returncode, done.stderr)

    return start


@pytest.fixture(scope="session")
def whole_run(run, tmp_path_factory):
    """The small rope, computed without interruption."""
    finished = run(tmp_path_factory.mktemp("small") / "whole")
    assert finished.code == 0, finished.stderr
    return finished
