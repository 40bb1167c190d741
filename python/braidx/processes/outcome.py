"""What a step of a programme hands over after each increment."""

from __future__ import annotations

from dataclasses import dataclass

from ..solver.increment import Increment
from .state import State


class NotConverged(Exception):
    """A step found no equilibrium. The message names the step, the reason and likely cures."""


@dataclass(frozen=True)
class Outcome:
    """A state in equilibrium and how it was reached.

    Attributes:
        state: The state to go on from; its increment number is set by the run.
        increment: The solver's report.
        share: How much of the step is done, 0 to 1.
        strain: Rope strain, None while the rope is formed.
        force: Force on the rope, N.
        cuts: Times the increment was cut before it converged.
        cost: Newton iterations and linear solves of all attempts.
        snapshot: Name under which the state is kept for pictures, if any.
        travel: How far the ends of a bent rope have been moved towards the sheave, mm.
        run: Way that it has been drawn over the sheave, mm.
        moment: Moment about the axis that the last section is turned with, N mm; None without groups of ends.
    """

    state: State
    increment: Increment
    share: float
    strain: float | None
    force: float
    cuts: int = 0
    cost: tuple[int, int] = (0, 0)
    snapshot: str | None = None
    moment: float | None = None
    travel: float | None = None
    run: float | None = None
