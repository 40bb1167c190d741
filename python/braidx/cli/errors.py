"""Exit codes, and how errors end a command: one line on stderr, no traceback."""

from __future__ import annotations

import importlib
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager

import typer

from braidx.scene import SceneError

BAD_INPUT = 2
NOT_CONVERGED = 3
PAUSE = 10.0  # s


def rank() -> int:
    """This process among those started by mpirun, 0 without it."""
    names = ("OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK")
    return int(next((os.environ[name] for name in names if name in os.environ), "0"))


def stop(message: str, code: int) -> typer.Exit:
    """Print one line on stderr, once however many processes run; raise what is returned.

    mpirun ends all processes as soon as one fails, so the first one goes first; the others get no
    further than their pause unless they fail alone.
    """
    if rank() > 0:
        time.sleep(PAUSE)
    typer.echo(f"braidx: {message}", err=True)
    return typer.Exit(code)


@contextmanager
def bad_input_stops(source: object = "") -> Iterator[None]:
    """Turn a SceneError into one line naming the file, and exit code 2."""
    try:
        yield
    except SceneError as error:
        raise stop(str(error.within(str(source))), BAD_INPUT) from None


def require_solver() -> None:
    """Stop with exit code 2 unless DOLFINx and the contact engine can be imported."""
    cures = {
        "dolfinx": "DOLFINx is missing; start with ./braidx from a checkout, which prepares it, or "
        "install fenics-dolfinx >= 0.9 (conda-forge, Debian, Ubuntu or the DOLFINx Docker image).",
        "petsc4py": "petsc4py is missing; install it beside DOLFINx, or start with ./braidx.",
        "braidx_engine": "the contact engine is not built; start with ./braidx from a checkout, or "
        "install with 'pip install .'.",
    }
    for module, cure in cures.items():
        try:
            importlib.import_module(module)
        except ImportError as error:
            reason = "" if error.name == module else f" ({error})"
            raise stop(cure + reason, BAD_INPUT) from None
