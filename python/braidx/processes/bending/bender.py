"""From one travel of the ends to the next, with increments that may be cut."""

from __future__ import annotations

from dataclasses import replace

from ...solver.increment import Diverged, Increment, IncrementOptions
from ...system.constraints import Floats
from ..attempt import Attempt, attempt
from ..outcome import NotConverged
from ..state import State
from .model import BentRope

# Of the stabilisation that straight ropes get: a rope that bends is held by its stiffness, and goes far.
CALM = 1e-3
PAIRED = (
    2e-3  # residual that fresh contact elements may leave: places on solids are found by repetition
)


class Bender:
    """Moves the ends of a bent rope, cutting increments that fail.

    Attributes:
        travel: Of both ends towards the sheave, mm.
        pretension: Force on either end along the axis of the straight rope, N.
    """

    def __init__(self, model: BentRope, state: State) -> None:
        self.model, self.state = model, state
        self.travel = state.progress.get("travel", 0.0)
        self.pretension = state.progress.get("pretension", 0.0)
        self._moved = state.progress.get("moved", 0.0)
        scene = model.scene
        self._options = IncrementOptions(
            pairing_tolerance=PAIRED,
            penetration=scene.contact.penetration_tolerance * scene.yarn.radius,
        )

    def to(self, travel: float) -> Attempt:
        """Solves for a travel (mm), or for one on the way there if that increment has to be cut.

        Raises:
            NotConverged: If the smallest increment fails too.
        """
        step = travel - self.travel
        done = attempt(
            lambda fraction, cuts: self._increment(fraction * step, cuts),
            lambda fraction: f"travel {self.travel + fraction * step:.3f} mm",
            self.model.scene.solver.max_cuts,
            lambda fraction, failure: self._give_up(self.travel + fraction * step, failure),
        )
        self._take(done.increment, done.fraction * step)
        return done

    def _increment(self, step: float, cuts: int) -> Increment:
        model, system, solver = self.model, self.model.system, self.model.scene.solver
        factor = CALM * 4.0**cuts
        model.set_viscosity(factor * solver.viscosity, factor * solver.director_viscosity)
        angle = self._angle + model.sheave.turn(model.scene, step)
        model.move(self.travel + step, self.pretension, angle)
        first = system.expand(system.free_values(self._predict(step)))
        return model.incrementer.solve(self.state.q, first, self._options)

    @property
    def _angle(self) -> float:
        """That the sheave has turned by, radians."""
        return self.state.progress.get("sheave_angle", 0.0)

    def _predict(self, step: float) -> Floats:
        """At the rate of the last increment: ropes that bend on keep it, and go back by the way that they came."""
        q, before = self.state.q, self.state.previous
        if not len(before) or not self._moved:
            return q
        predicted: Floats = q + step / self._moved * (q - before)
        return predicted

    def _take(self, increment: Increment, step: float) -> None:
        self.travel += step
        self._moved = step
        state = self.state
        energy = self.model.internal_energy(increment.q)
        progress = {
            "energy": max(energy, state.progress.get("energy", 0.0)),
            "travel": self.travel,
            "moved": step,
            "pretension": self.pretension,
            "sheave_angle": self._angle + self.model.assembly.sheave.turned(state.q, increment.q),
            "furthest": max(self.travel, state.progress.get("furthest", 0.0)),
        }
        self.state = replace(
            state,
            q=increment.q,
            previous=state.q,
            contacts=self.model.contact.arrays(),
            progress={**state.progress, **progress},
            stabilisation_work=state.stabilisation_work + increment.stabilisation_work,
            stabilisation_residual=state.stabilisation_residual + increment.stabilisation_residual,
            friction_work=state.friction_work + increment.friction_work,
        )

    def _give_up(self, travel: float, failure: Diverged) -> NotConverged:
        return NotConverged(
            f"no equilibrium at a travel of {travel:.3f} mm: {failure}; deepest contacts between surfaces "
            f"{failure.deepest}; try more steps.increments, a higher solver.viscosity, or a small steps.pretension"
        )
