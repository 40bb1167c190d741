"""Where this process prints: a terminal of its own, a file or pipe, or one of several MPI ranks."""

from __future__ import annotations

import os

from rich.console import Console

FILE_WIDTH = 120  # columns of what is printed into files and pipes
RANK_NAMES = ("OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK")  # as Open MPI, PMIx and MPICH set it


def rank() -> int:
    """This process among those started by mpirun, 0 without it."""
    return int(next((os.environ[name] for name in RANK_NAMES if name in os.environ), "0"))


def make_console() -> Console:
    """The console of this process; only the first rank prints.

    Escape codes go to terminals only. Under mpirun standard output may be a pseudo terminal whatever it is led to
    in the end, so there are none.
    """
    under_mpirun = any(name in os.environ for name in RANK_NAMES)
    console = Console(quiet=rank() != 0, force_terminal=False if under_mpirun else None)
    if not console.is_terminal:
        console.width = FILE_WIDTH
    return console
