"""Settle: a rope comes to rest at a force."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..scene import Settle
from .model import RopeModel
from .newton_options import UNSTRETCHED
from .outcome import Outcome
from .pull import outcome
from .puller import Puller
from .state import State

SETTLED = (
    0.05  # settled: the force is missed by less than this fraction (at zero force: yarns would
)
# be strained by less than UNSTRETCHED), and
SOFTER = 4.0  # most that a rope is taken to give way more than parallel yarns would


def settle(model: RopeModel, state: State, step: Settle) -> Iterator[Outcome]:
    """Lets the rope come to rest at a force."""
    settler = Settler(model, state, step)
    while not settler.finished:
        yield settler.increment()


class Settler:
    """The way of a rope to a force; all its numbers are in the state's progress, to go on from a checkpoint.

    The end is moved by what the force that is missing needs with the stiffness found between the last two states.
    """

    def __init__(self, model: RopeModel, state: State, step: Settle) -> None:
        self.model, self.step = model, step
        self._puller = Puller(model, state)
        self._parallel = model.rope.num_yarns * model.scene.yarn.axial_stiffness
        self._wanted = 1e3 * step.force
        self._near = max(SETTLED * self._wanted, UNSTRETCHED * self._parallel)
        start = {"settled": 0.0, "target": self._puller.strain, "stiffness": self._parallel}
        self._number = {name: state.progress.get(name, value) for name, value in start.items()}

    @property
    def finished(self) -> bool:
        """Whether the rope rests, or the increments are used up, and groups of ends are where they are wanted."""
        return self._number["settled"] >= self.step.increments and self._puller.grown(self.step)

    def increment(self) -> Outcome:
        """One increment towards rest."""
        puller, number, increments = self._puller, self._number, self.step.increments
        # Groups of ends have half of the increments to get where they are wanted.
        share = puller.next_share(self.step, (increments + 1) // 2 - int(number["settled"]))
        before, strain = puller.force(), puller.strain
        attempt = puller.to(number["target"], share)
        number["settled"] += 1
        self._aim(before, strain)
        puller.state = replace(puller.state, progress={**puller.state.progress, **number})
        name = "settled" if self.finished else None
        return outcome(puller, attempt, min(1.0, number["settled"] / increments), name)

    def _aim(self, before: float, at: float) -> None:
        """Where the end is moved next, after a force before (N) at a strain; nowhere once the force is met."""
        puller, number = self._puller, self._number
        missing, moved = self._wanted - puller.force(), puller.strain - at
        if moved:
            found = (puller.force() - before) / moved
            number["stiffness"] = float(np.clip(found, self._parallel / SOFTER, self._parallel))
        near = abs(missing) <= self._near
        number["target"] = puller.strain + (0.0 if near else missing / number["stiffness"])
        if near and puller.grown(self.step):
            number["settled"] = float(self.step.increments)
