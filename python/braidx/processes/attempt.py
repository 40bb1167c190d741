"""Increments that are cut until one of them is solved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..output.log import LOGGER
from ..solver.increment import Diverged, Increment
from .outcome import NotConverged


@dataclass(frozen=True)
class Attempt:
    """A solved increment and what all attempts at it cost.

    Attributes:
        increment: The one that was solved.
        fraction: How much of the increment asked for it is, in (0, 1].
        cuts: How often it was halved.
        iterations, linear_solves: Of all attempts.
    """

    increment: Increment
    fraction: float
    cuts: int
    iterations: int
    linear_solves: int


def attempt(
    solve: Callable[[float, int], Increment],
    where: Callable[[float], str],
    max_cuts: int,
    give_up: Callable[[float, Diverged], NotConverged],
) -> Attempt:
    """Solves an increment, or the first of its halves, quarters and so on that can be solved.

    Args:
        solve: Solves a fraction of the increment after a number of cuts; raises Diverged.
        where: Names the end of a fraction of it, for the log.
        max_cuts: How often it may be halved.
        give_up: What to raise where the smallest fraction fails too.
    Raises:
        NotConverged: As given.
    """
    fraction, cuts, iterations, solves = 1.0, 0, 0, 0
    while True:
        try:
            increment = solve(fraction, cuts)
        except Diverged as failure:
            iterations, solves = iterations + failure.iterations, solves + failure.linear_solves
            cuts += 1
            LOGGER.warning("increment to %s cut: %s", where(fraction), failure)
            if cuts > max_cuts:
                raise give_up(fraction, failure) from failure
            fraction /= 2
            continue
        iterations, solves = iterations + increment.iterations, solves + increment.linear_solves
        return Attempt(increment, fraction, cuts, iterations, solves)
