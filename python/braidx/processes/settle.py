"""Settle: a rope comes to rest at a force."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..scene import Settle
from .model import RopeModel
from .newton_options import UNSTRETCHED
from .outcome import NotConverged, Outcome
from .pull import outcome
from .puller import Puller
from .state import State

NEAR = 0.05  # groups of ends: the force is met when it is missed by less than this fraction (at zero force: when yarns
# would be strained by less than UNSTRETCHED by it)
SOFTER = 4.0  # most that a rope is taken to give way more than parallel yarns would


def settle(model: RopeModel, state: State, step: Settle) -> Iterator[Outcome]:
    """Lets the rope come to rest at a force."""
    if model.ends.grouped:
        settler = Settler(model, state, step)
        while not settler.finished:
            yield settler.increment()
    else:
        yield from _at_force(Puller(model, state), step)


def _at_force(puller: Puller, step: Settle) -> Iterator[Outcome]:
    """The equilibrium under the force: states on the way there are none, and are not handed over.

    Raises:
        NotConverged: If it is not found in as many increments as the step has.
    """
    iterations = solves = 0
    for _ in range(step.increments):
        attempt = puller.rest(1e3 * step.force)
        iterations, solves = iterations + attempt.iterations, solves + attempt.linear_solves
        if attempt.increment.residual < puller.model.scene.solver.tolerance:
            found = replace(attempt, iterations=iterations, linear_solves=solves)
            yield outcome(puller, found, 1.0, "settled")
            return
    raise NotConverged(
        f"the rope does not come to rest in {step.increments} increments; try more steps.increments, or a larger "
        "contact.friction"
    )


class Settler:
    """The way of a rope with groups of ends to a force; all its numbers are in the state's progress.

    The end is moved by what the force that is missing needs with the stiffness found between the last two states.
    """

    def __init__(self, model: RopeModel, state: State, step: Settle) -> None:
        self.step, self._puller = step, Puller(model, state)
        self._parallel = model.parallel_stiffness
        self._wanted = 1e3 * step.force
        self._near = max(NEAR * self._wanted, UNSTRETCHED * self._parallel)
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
