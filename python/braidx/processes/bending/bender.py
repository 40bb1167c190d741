"""From what the ends are asked for to what is asked for next, with increments that may be cut."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...solver.increment import Diverged, Increment, IncrementOptions
from ...system.constraints import Floats
from ..attempt import Attempt, attempt
from ..outcome import NotConverged
from ..state import State
from .ends import PARTS, Ends
from .model import BentRope

LAST = tuple(f"last_{name}" for name in PARTS)  # step of the last increment

# Of the stabilisation that straight ropes get: a rope that bends is held by its stiffness, and goes far.
CALM = 1e-3
PAIRED = (
    2e-3  # residual that fresh contact elements may leave: places on solids are found by repetition
)


class Bender:
    """Moves the ends of a bent rope, cutting increments that fail.

    Attributes:
        ends: What they have been asked for.
    """

    def __init__(self, model: BentRope, state: State) -> None:
        self.model, self.state = model, state
        self.ends = Ends.reached(state.progress)
        scene = model.scene
        self._options = IncrementOptions(
            pairing_tolerance=PAIRED,
            penetration=scene.contact.penetration_tolerance * scene.yarn.radius,
        )

    def to(self, aim: Ends) -> Attempt:
        """Solves for an aim, or for one on the way there if that increment has to be cut.

        Raises:
            NotConverged: If the smallest increment fails too.
        """
        done = attempt(
            lambda fraction, cuts: self._increment(self.ends.towards(aim, fraction), cuts),
            lambda fraction: str(self.ends.towards(aim, fraction)),
            self.model.scene.solver.max_cuts,
            lambda fraction, failure: self._give_up(self.ends.towards(aim, fraction), failure),
        )
        self._take(done.increment, self.ends.towards(aim, done.fraction))
        return done

    def _increment(self, aim: Ends, cuts: int) -> Increment:
        model, system, solver = self.model, self.model.system, self.model.scene.solver
        factor = CALM * 4.0**cuts
        model.set_viscosity(factor * solver.viscosity, factor * solver.director_viscosity)
        angle = self._angle + model.sheave.turn(model.scene, aim.travel - self.ends.travel)
        model.move(aim, angle)
        first = system.expand(system.free_values(self._predict(aim.parts - self.ends.parts)))
        return model.incrementer.solve(self.state.q, first, self._options)

    @property
    def _angle(self) -> float:
        """That the sheave has turned by, radians."""
        return self.state.progress.get("sheave_angle", 0.0)

    def _predict(self, step: Floats) -> Floats:
        """At the rate of the last increment: ropes that bend on keep it, and go back by the way that they came."""
        q, before = self.state.q, self.state.previous
        last = np.array([self.state.progress.get(name, 0.0) for name in LAST])
        if not len(before) or not last.any():
            return q
        # Of a step of another kind the last one knows nothing.
        predicted: Floats = q + (step @ last) / (last @ last) * (q - before)
        return predicted

    def _take(self, increment: Increment, reached: Ends) -> None:
        step = reached.parts - self.ends.parts
        self.ends = reached
        state = self.state
        energy = self.model.internal_energy(increment.q)
        progress = {
            "energy": max(energy, state.progress.get("energy", 0.0)),
            **reached.progress(),
            **dict(zip(LAST, map(float, step), strict=True)),
            "sheave_angle": self._angle + self.model.assembly.sheave.turned(state.q, increment.q),
            "furthest": max(reached.travel, state.progress.get("furthest", 0.0)),
        }
        self.state = replace(
            state,
            q=increment.q,
            previous=state.q,
            contacts=self.model.contact.arrays(),
            progress={**state.progress, **progress},
            stabilisation_work=state.stabilisation_work + increment.stabilisation_work,
            stabilisation_residual=state.stabilisation_residual + increment.stabilisation_work,
            friction_work=state.friction_work + increment.friction_work,
        )

    def _give_up(self, aim: Ends, failure: Diverged) -> NotConverged:
        return NotConverged(
            f"no equilibrium at {aim}: {failure}; deepest contacts between surfaces {failure.deepest}; try more "
            "steps.increments, a higher solver.viscosity, or a small steps.pretension"
        )
