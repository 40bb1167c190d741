"""Families of scenes, their runs, and where their outcomes are kept until the report is written."""

from __future__ import annotations

import itertools
import logging
import multiprocessing
import os
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from judge import CONVERGED, FAILED, REFUSED, SLOW, WRONG, Outcome, with_slowness

DONE: dict[str, list[Outcome]] = {}  # outcomes of this run by name of the family


@dataclass(frozen=True)
class Family:
    """Scenes over one or two parameters.

    Attributes:
        name: Of its map, docs/images/stability_NAME.png.
        title: Heading.
        axes: What the parameters are, with their units; one or two.
        values: Of each parameter; or None where `cases` are given.
        outcome: Makes, solves and judges the scene with these parameters.
        says: What the scene is.
        means: What its map means for the choices of a user.
        logarithmic: Whether each axis has a logarithmic scale.
        labels: Of the values of the second parameter, where numbers say nothing.
        chosen: Whether a combination is computed; all are by default.
        draw: Writes a map of its own.
        together: How many scenes one process takes after each other: those that go on from one another.
    """

    name: str
    title: str
    axes: tuple[str, ...]
    values: tuple[Sequence[float], ...]
    outcome: Callable[..., Outcome]
    says: str
    means: str = ""
    logarithmic: tuple[bool, ...] = (True, True)
    labels: tuple[str, ...] = ()
    chosen: Callable[..., bool] = lambda *case: True
    draw: Callable[[Family, Sequence[Outcome], Path], None] | None = None
    together: int = 1


@cache
def explore(family: Family) -> dict[tuple[float, ...], Outcome]:
    """Outcomes of all scenes of a family by their parameters; computed once per process."""
    found = [outcome for some in begun(family) for outcome in _told(some.result())]
    DONE[family.name] = with_slowness(found)
    return dict(zip(cases(family), DONE[family.name], strict=True))


@cache
def begun(family: Family) -> list[Future[list[Outcome]]]:
    """Scenes of a family, some after each other where they go on from one another, as they come to be done."""
    size, all_cases = family.together, cases(family)
    groups = [all_cases[first : first + size] for first in range(0, len(all_cases), size)]
    return [workers().submit(_outcomes, family.outcome, group) for group in groups]


def cases(family: Family) -> list[tuple[float, ...]]:
    """Parameters of its scenes."""
    return [case for case in itertools.product(*family.values) if family.chosen(*case)]


def _outcomes(outcome: Callable[..., Outcome], group: Sequence[tuple[float, ...]]) -> list[Outcome]:
    return [outcome(*case) for case in group]


def _told(outcomes: list[Outcome]) -> list[Outcome]:
    for outcome in outcomes:
        print(line(outcome), flush=True)
    return outcomes


@cache
def workers() -> ProcessPoolExecutor:
    """Processes that compute scenes side by side, one thread each; started afresh, as MPI cannot be forked."""
    for threads in ("BRAIDX_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[threads] = "1"  # of the processes to come
    number = min(len(os.sched_getaffinity(0)), 4)
    return ProcessPoolExecutor(number, multiprocessing.get_context("spawn"), _be_quiet)


def _be_quiet() -> None:
    logging.getLogger("braidx").setLevel(logging.ERROR)


def line(outcome: Outcome) -> str:
    """One line about an outcome."""
    case = ", ".join(f"{value:g}" for value in outcome.case)
    return (
        f"({case}): {outcome.status}, {outcome.iterations} iterations, {outcome.increments} increments, "
        f"{outcome.cuts} more than asked; forces {outcome.force_error:.0e}, moments {outcome.moment_error:.0e}, "
        f"penetration {outcome.penetration:.4f}, nearest {outcome.nearest:.3f}, energy {outcome.energy_error:+.3f}, "
        f"{outcome.seconds:.1f} s {outcome.values or ''} {outcome.why}"
    )


def cases_with(
    outcomes: dict[tuple[float, ...], Outcome], *statuses: str
) -> set[tuple[float, ...]]:
    """Parameters of the scenes that ended in one of these ways."""
    return {case for case, outcome in outcomes.items() if outcome.status in statuses}


def good(outcomes: dict[tuple[float, ...], Outcome]) -> set[tuple[float, ...]]:
    """Parameters of the scenes that converged, if slowly."""
    return cases_with(outcomes, CONVERGED, SLOW)


def none_is_wrong(outcomes: dict[tuple[float, ...], Outcome]) -> bool:
    """Whether all that failed said so."""
    return not cases_with(outcomes, WRONG)


def counts(outcomes: Sequence[Outcome]) -> str:
    """How many ended in which way, in words."""
    numbers = {s: sum(o.status == s for o in outcomes) for s in (CONVERGED, SLOW, FAILED, WRONG)}
    refused = sum(outcome.status == REFUSED for outcome in outcomes)
    numbers |= {REFUSED: refused} if refused else {}
    return ", ".join(f"{number} {status}" for status, number in numbers.items())
