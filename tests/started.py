"""Programs that tests start: on one process or several, for as long as they take, and ended with their test."""

from __future__ import annotations

import ctypes
import os
import shutil
import signal
import subprocess
from pathlib import Path

import pytest

needs_mpirun = pytest.mark.skipif(shutil.which("mpirun") is None, reason="needs mpirun")

# Ranks on one machine, one thread each, which wait without taking a core.
ONE_MACHINE = {
    "OMPI_MCA_btl": "self,sm",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "BRAIDX_THREADS": "1",
}
LIBC = ctypes.CDLL(None)
PR_SET_PDEATHSIG = 1  # <sys/prctl.h>


def run(
    *words: object, ranks: int = 0, folder: Path | None = None, **variables: str
) -> subprocess.CompletedProcess[str]:
    """Runs a program to its end; nothing of it is left if the test is interrupted or killed.

    Args:
        words: The command.
        ranks: MPI processes; 0 starts it without mpirun.
        folder: To start it in.
        variables: Of its environment, beside this process's.
    """
    mpirun = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks else []
    process = subprocess.Popen(
        [*mpirun, *map(str, words)],
        cwd=folder,
        env=os.environ | ONE_MACHINE | variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=_end_with_parent,
    )
    try:
        out, err = process.communicate()
    except BaseException:
        process.terminate()  # mpirun ends its ranks, which it could not if it were killed
        process.wait()
        raise
    return subprocess.CompletedProcess(words, process.returncode, out, err)


def is_running(process: str) -> bool:
    """Whether a process, by its number, has neither ended nor waits for its parent to take note of its end."""
    try:
        status = Path("/proc", process, "stat").read_text()
    except OSError:
        return False
    return status.rpartition(")")[2].split()[0] not in "ZX"


def _end_with_parent() -> None:
    """Linux tells this process when its parent has ended, however it did."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
