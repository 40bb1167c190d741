"""What a computation costs: CPU seconds of the process, unknowns, Newton iterations."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from petsc4py import PETSc

from braidx.solver.newton import Newton
from braidx.solver.petsc_options import PREFIX


@dataclass
class Tally:
    """Counted so far; see Outcome."""

    seconds: float = 0.0
    unknowns: int = 0
    iterations: int = 0


@contextmanager
def tally() -> Iterator[Tally]:
    """Counts what is solved for within, attempts that fail included."""
    counted, solve = Tally(), Newton.solve

    def counting(newton: Newton, *words: Any, **named: Any) -> Any:
        counted.unknowns = max(counted.unknowns, newton.system.num_free)
        found, result = solve(newton, *words, **named)
        counted.iterations += result.iterations
        return found, result

    Newton.solve = counting  # type: ignore[method-assign]
    begin = time.process_time()
    try:
        yield counted
    finally:
        counted.seconds = time.process_time() - begin
        Newton.solve = solve  # type: ignore[method-assign]


@contextmanager
def factors_of(package: str) -> Iterator[None]:
    """Linear systems are factorised by a package that PETSc knows; "": that which braidx chooses."""
    options = PETSc.Options(PREFIX)
    if package:
        options["pc_factor_mat_solver_type"] = package
    try:
        yield
    finally:
        if package:
            options.delValue("pc_factor_mat_solver_type")
