"""Where the work of pulling a rope goes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Taken:
    """Work of the force on a rope on a way through states of equilibrium, and what takes it, mJ.

    Forces are those at begin and end of each increment, in the mean, so that the balance is that of virtual work: it
    holds however far the increments go. Penalties that are raised between increments do no work.

    Attributes:
        pull: Of the force on the rope.
        strain, press: What yarns take, and what presses them on each other.
        rub_first, rub_last: What friction takes with its forces at the begin, and at the end of increments.
        held: What the stabilisation takes.
        springs: What friction may give back of it, or take besides: its forces times the slip that is reversible.
        told: Friction work as the run tells it.
        largest: What small is measured against: the largest of work and elastic energies.
    """

    pull: float
    strain: float
    press: float
    rub_first: float
    rub_last: float
    held: float
    springs: float
    told: float
    largest: float

    @property
    def lost(self) -> float:
        """Work that is missing (positive) or made (negative), over the largest."""
        rub = (self.rub_first + self.rub_last) / 2.0
        return (self.pull - self.strain - self.press - rub - self.held) / self.largest

    @property
    def untold(self) -> float:
        """Friction work beyond what friction takes with the forces of either end of increments, over the largest."""
        low, high = sorted((self.rub_first, self.rub_last))
        above, below = self.told - high - self.springs, low - self.springs - self.told
        return (max(0.0, above) - max(0.0, below)) / self.largest


def work_of(force: Floats, place: Floats) -> tuple[float, float]:
    """Work of a force on the way from place to place, and what the trapezium rule may miss, by second differences.

    Args:
        force, place: Shape (n,), N and mm.
    """
    moved = np.diff(place)
    bends = np.abs(np.diff(force, 2)) if len(force) > 2 else np.abs(np.diff(force))
    bent = np.maximum(np.append(bends, 0.0), np.append(0.0, bends))[: len(moved)]
    work = float((force[1:] + force[:-1]) / 2.0 @ moved)
    return work, float(bent @ np.abs(moved)) / 6.0
