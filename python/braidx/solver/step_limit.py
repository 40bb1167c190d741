"""How much is taken of the steps of Newton's method."""

from __future__ import annotations

import numpy as np
from mpi4py import MPI

from ..system.constraints import Floats

REVERSED = -0.8  # cosine of the angle between two steps below which the second takes back the first
LEAST_SHARE = 1.0 / 16.0  # of a step that takes back one that took back one...


class StepLimit:
    """Cuts steps that are too long, and those that take back the ones before.

    Contacts that open and close by turns let full steps go back and forth between two states for ever. What is looked
    for lies between these: a step that takes back the last one is halved, and halved again as long as that goes on.

    Attributes:
        max_step: Largest change of a position, mm; larger steps are scaled down.
        max_turn: Largest change of a director component; those are cut one by one.
        halving: Whether steps that take back the last one are cut.
    """

    def __init__(self, comm: MPI.Comm, max_step: float, max_turn: float, halving: bool) -> None:
        self.comm, self.max_step, self.max_turn = comm, max_step, max_turn
        self.halving = halving
        self.restart()

    def restart(self) -> None:
        """Steps to come have nothing to do with those before."""
        self._last: Floats | None = None
        self._share = 1.0

    def apply(self, step: Floats, turning: np.ndarray) -> None:
        """Cuts this process's part of a step.

        Args:
            step: shape (n,), changed.
            turning: Which of it belongs to directors, shape (n,).
        """
        step[turning] = np.clip(step[turning], -self.max_turn, self.max_turn)
        longest = self.comm.allreduce(float(np.abs(step[~turning]).max(initial=0.0)), op=MPI.MAX)
        if longest > self.max_step:
            step *= self.max_step / longest
        if not self.halving:
            return
        moved = step[~turning]
        self._share = self._next_share(moved)
        self._last = self._share * moved
        step *= self._share

    def _next_share(self, moved: Floats) -> float:
        if self._last is None:
            return 1.0
        products = np.array([moved @ self._last, self._last @ self._last, moved @ moved])
        along, old, new = self.comm.allreduce(products)
        if along < REVERSED * np.sqrt(old * new) and new > old / 4.0:
            return max(self._share / 2.0, LEAST_SHARE)
        return min(2.0 * self._share, 1.0)
