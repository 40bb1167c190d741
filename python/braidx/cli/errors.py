"""Exit codes, and how errors end a command: one line on stderr, no traceback."""

from __future__ import annotations

import importlib
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import typer

from braidx.output.console import rank
from braidx.scene import SceneError

MISSED = 1  # a result is not as expected, where --strict asks for that
BAD_INPUT = 2
NOT_CONVERGED = 3
INTERRUPTED = 130  # as shells count: 128 and the number of SIGINT
TOGETHER = (MISSED, NOT_CONVERGED, INTERRUPTED)  # all processes end with these
PAUSE = 10.0  # s


def stop(message: str, code: int) -> typer.Exit:
    """Print one line on stderr, once however many processes run; raise what is returned.

    mpirun ends all processes as soon as one fails, so the first one goes first; the others get no
    further than their pause unless they fail alone.
    """
    if rank() > 0 and code in TOGETHER:
        return typer.Exit(code)
    if rank() > 0:
        time.sleep(PAUSE)
    typer.echo(f"braidx: {message}", err=True)
    return typer.Exit(code)


@contextmanager
def bad_input_stops(source: object = "") -> Iterator[None]:
    """Turn a SceneError into one line naming the file, and exit code 2; an interrupt into exit code 130."""
    try:
        yield
    except KeyboardInterrupt:
        raise stop("interrupted", INTERRUPTED) from None
    except SceneError as error:
        raise stop(str(error.within(str(source))), BAD_INPUT) from None


def missed(results: Mapping[str, Mapping[str, object]]) -> str:
    """Names of the results that are not as expected, separated by commas."""
    return ", ".join(name for name, result in results.items() if result["met"] is False)


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
