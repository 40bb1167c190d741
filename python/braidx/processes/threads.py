"""How many threads the contact engine uses in each process."""

from __future__ import annotations

import os

from mpi4py import MPI

from ..scene import SceneError

VARIABLE = "BRAIDX_THREADS"


def num_threads(comm: MPI.Comm) -> int:
    """Threads per process: what BRAIDX_THREADS says, else this machine's cores shared among its processes.

    Raises:
        SceneError: If BRAIDX_THREADS is no whole number above 0.
    """
    given = os.environ.get(VARIABLE)
    if given:
        if not given.isdecimal() or int(given) < 1:
            raise SceneError(VARIABLE, "give a whole number of threads, at least 1.", given)
        return int(given)
    on_this_machine = comm.Split_type(MPI.COMM_TYPE_SHARED)
    processes = on_this_machine.size
    on_this_machine.Free()
    return max(1, available_cores() // processes)


def available_cores() -> int:
    """Cores that this process may run on."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
