"""Settle: a rope comes to rest at a force."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ..scene import Settle
from .model import RopeModel
from .newton_options import UNSTRETCHED
from .outcome import NotConverged, Outcome
from .pull import outcome
from .puller import Puller
from .state import State

SETTLED = (
    0.05  # settled: the force is missed by less than this fraction (at zero force: yarns would
)
# be strained by less than UNSTRETCHED), and
STRIDES = 4.0  # most of what parallel yarns would need that the end is moved by
REST = 1e-3  # the stabilisation's work in an increment, over the internal energy
LITTLE = 0.01  # its share below which a stabilisation that could not let go once tries to again


def settle(model: RopeModel, state: State, step: Settle) -> Iterator[Outcome]:
    """Lets the rope come to rest at a force: until that is met and the stabilisation does no more work."""
    settler = Settler(model, state, step)
    while not settler.finished:
        yield settler.increment()


class Settler:
    """The way of a rope to rest; all its numbers are in the state's progress, so that it can go on from a checkpoint.

    The end is moved by what parallel yarns would need for the force that is missing, and by more and more of it while
    the rope gives way. On the way the stabilisation becomes what an increment can do with, so that the rope goes far in
    few increments; at its end it is what it is in other steps, or less. Where it could not let go of a state, it holds
    the next ones, too, each from where the last one was found, until there is little left to hold.
    """

    def __init__(self, model: RopeModel, state: State, step: Settle) -> None:
        self.model, self.step = model, step
        self._puller = Puller(model, state)
        self._puller.rests = False  # within an increment: that is what all of them are for
        self._parallel = model.rope.num_yarns * model.scene.yarn.axial_stiffness
        self._wanted = 1e3 * step.force
        self._near = max(SETTLED * self._wanted, UNSTRETCHED * self._parallel)
        start = {
            "settled": 0.0,
            "target": self._puller.strain,
            "missing": 0.0,
            "stride": 1.0,
            "held": 0.0,
        }
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
        # A rope whose end has arrived creeps on by what the stabilisation holds back.
        puller.releases = self._has_arrived and number["held"] < LITTLE
        attempt = puller.to(number["target"], share)
        number["settled"] += 1
        held = puller.held_share(attempt.increment)
        number["held"] = held if attempt.increment.held or number["held"] else 0.0
        self._aim()
        if held < REST and self._has_arrived and puller.grown(self.step):
            number["settled"] = float(increments)
        puller.calm(attempt.iterations)
        if number["settled"] >= increments - 1:  # the last one is to be at rest
            puller.calming = min(puller.calming, 1.0)
        puller.state = replace(
            puller.state,
            # On the way to rest the stabilisation works as it should: what counts is what it still does there.
            stabilisation_residual=attempt.increment.stabilisation_residual,
            progress={**puller.state.progress, **number, "calming": puller.calming},
        )
        if self.finished and number["held"] and not puller.is_at_rest(attempt.increment):
            raise NotConverged(
                f"the rope does not come to rest in {increments} increments; try more steps.increments, or a larger "
                "contact.friction"
            )
        name = "settled" if self.finished else None
        return outcome(puller, attempt, min(1.0, number["settled"] / increments), name)

    @property
    def _has_arrived(self) -> bool:
        """Whether the end stays where it is, under no more stabilisation than the scene asks for."""
        return self._number["target"] == self._puller.strain and self._puller.calming <= 1.0

    def _aim(self) -> None:
        """Where the end is moved next."""
        number, strain = self._number, self._puller.strain
        before, missing = number["missing"], self._wanted - self._puller.force()
        gives_way = missing * before > 0.5 * before**2
        number["stride"] = min(2 * number["stride"], STRIDES) if gives_way else 1.0
        number["missing"] = missing
        way = number["stride"] * missing / self._parallel
        number["target"] = strain + (way if abs(missing) > self._near else 0.0)
