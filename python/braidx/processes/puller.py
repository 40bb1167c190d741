"""From one rope strain to the next, and from one state of the ends to the next, with increments that may be cut."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..scene import Hold, Settle
from ..solver.increment import Diverged, Increment, IncrementOptions
from ..system.constraints import Floats
from .attempt import Attempt, attempt
from .grouped_ends import GroupedEnds
from .model import RopeModel
from .outcome import NotConverged
from .state import State

SLACK = 1e-6  # mean strain below which yarns are slack
EASED = 0.1  # least share of themselves that penalties fall to in an increment
BENT = 1e-3  # of a yarn radius: distance from rigid that is left to a group of ends
TURNS = 8  # repetitions of an increment in which bodies turn on
GROWN = 1e-9  # what groups of ends are to reach is missed by less than this share


class Puller:
    """Goes from one rope strain to the next, cutting increments that fail.

    Attributes:
        strain: Rope strain of the state.
        share: What is reached of what groups of ends ask for, 0 to 1.
        eases: Whether penalties fall with the tension of yarns, too, and do not only rise with it.
    """

    def __init__(self, model: RopeModel, state: State) -> None:
        self.model, self.state = model, state
        self.strain = state.progress.get("strain", 0.0)
        self.share = state.progress.get("share", 0.0)
        self.eases = False
        # Mean tension of the yarns that penalties are made for: they go with what is expected of increments.
        self._made_for = state.progress.get("tension", 0.0) or self._mean_tension(state.q)
        self._expected = self._made_for
        scene = model.scene
        penetration = scene.contact.penetration_tolerance * model.rope.radius.min()
        self._options = IncrementOptions(penetration=penetration)
        self._bent = BENT * model.rope.radius.min()

    def to(self, strain: float, share: float | None = None, part: float = 1.0) -> Attempt:
        """Solves for a strain, or for one on the way there if that increment has to be cut.

        Args:
            strain: Rope strain.
            share: How much is then reached of what groups of ends ask for; as much as now by default.
            part: Of the increment that the step asks for, which may have been cut before. Small parts may be halved
                less often: those that are halved time after time go nowhere, and never end.
        Raises:
            NotConverged: If the smallest increment fails too.
        """
        step = strain - self.strain
        growth = 0.0 if share is None else share - self.share

        def solve(fraction: float, cuts: int) -> Increment:
            return self._increment(self.strain + fraction * step, self.share + fraction * growth)

        done = attempt(
            solve,
            lambda fraction: f"strain {self.strain + fraction * step:.5f}",
            self._cuts_left(part),
            lambda fraction, failure: self._give_up(self.strain + fraction * step, failure),
        )
        part = done.fraction
        self._take(done.increment, self.strain + part * step, self.share + part * growth)
        return done

    def rest(self, force: float) -> Attempt:
        """Lets the rope come to rest under a force (N) that moves its last end section, or a part of the way there.

        It may have far to go at the same force, so that an increment ends at its last step, wherever that is.
        """
        model, ends = self.model, self.model.ends
        assert not isinstance(ends, GroupedEnds)
        model.system.constraints, model.system.constraint_values = ends.pulled
        model.pull_by(force)
        missing = force - self.force()
        guess = self._predict(self.strain + missing / model.parallel_stiffness, self.share)
        found = self._equilibrium(guess, replace(self._options, in_passing=True))
        self._take(found, ends.strain_of(found.q), self.share)
        return Attempt(found, 1.0, 0, found.iterations, found.linear_solves)

    def _cuts_left(self, part: float) -> int:
        most = self.model.scene.solver.max_cuts
        return int(np.clip(2 * most + np.log2(part), 0, most))

    def force(self) -> float:
        """Force on the rope now, N."""
        return self.model.axial_force(self.state.q)

    def grown(self, step: Settle | Hold) -> bool:
        """Whether groups of ends have reached what the step wants of them."""
        return not self.model.ends.grouped or abs(step.ends - self.share) < GROWN

    def next_share(self, step: Settle | Hold, increments: int) -> float:
        """What groups of ends are to reach in the next of so many increments."""
        left = 0.0 if self.grown(step) else step.ends - self.share
        return self.share + left / max(increments, 1)

    def _increment(self, strain: float, share: float) -> Increment:
        before = self.model.contact.elements.copy() if self.model.ends.grouped else None
        guess, iterations, solves = self._predict(strain, share), 0, 0
        for _ in range(TURNS + 1):
            increment = self._solve(guess, strain, share)
            iterations += increment.iterations
            solves += increment.linear_solves
            if self._is_rigid(increment.q):
                return replace(increment, iterations=iterations, linear_solves=solves)
            # Bodies turned on from where they were expected: once more, from where they are found.
            self.model.contact.restore(before)
            guess = increment.q
        raise Diverged("a rigid group of ends turns without coming to rest", iterations, solves)

    def _solve(self, guess: Floats, strain: float, share: float) -> Increment:
        """Equilibrium for small motions of groups of ends from where they are in the guess, or asked to be."""
        model, ends, system = self.model, self.model.ends, self.model.system
        placed = ends.place(guess, strain, share)
        system.constraints, system.constraint_values = ends.held(strain, share, placed)
        if isinstance(ends, GroupedEnds):
            model.loads.loads = ends.loads(placed, share)
        else:
            model.pull_by(0.0)
        return self._equilibrium(placed, self._options)

    def _equilibrium(self, guess: Floats, options: IncrementOptions) -> Increment:
        """Equilibrium near a guess, for the constraints and loads that the system has."""
        model, system = self.model, self.model.system
        first = system.expand(system.free_values(guess))
        least = EASED if self.eases else 1.0
        self._expected = max(self._mean_tension(first), least * self._made_for)
        slack = self._made_for < SLACK * model.scene.yarn.axial_stiffness
        stiffening = 1.0 if slack else self._expected / self._made_for
        model.measure(self._expected)
        return model.continuation.solve(self.state.q, first, options, stiffening)

    def _is_rigid(self, q: Floats) -> bool:
        ends = self.model.ends
        return not isinstance(ends, GroupedEnds) or ends.bent(q) < self._bent

    def _mean_tension(self, q: Floats) -> float:
        return float(np.mean(self.model.tension(q)))

    def _predict(self, strain: float, share: float) -> Floats:
        """The state stretched along the axis; where groups of ends are moved, each yarn goes along with its ends.

        Not at the rate of the last increment: how yarns slipped then is no guide to how they will.
        """
        rows = self.state.q.reshape(self.model.body.num_nodes, -1).copy()
        rows[:, 2] *= (1.0 + strain) / (1.0 + self.strain)
        moved: Floats = rows.ravel()
        return moved if share == self.share else self.model.ends.carry(moved, strain, share)

    def _take(self, increment: Increment, strain: float, share: float) -> None:
        self.strain, self.share = strain, share
        self._made_for = self._expected
        if self._made_for < SLACK * self.model.scene.yarn.axial_stiffness:
            # Nothing was expected of slack yarns: penalties became what was found to do.
            self._made_for = max(self._made_for, self._mean_tension(increment.q))
        before, energy = self.state.progress, self.model.internal_energy(increment.q)
        self.state = replace(
            self.state,
            q=increment.q,
            contacts=self.model.contact.arrays(),
            progress={
                **before,
                "energy": max(energy, before.get("energy", 0.0)),
                "strain": strain,
                "share": share,
                "tension": self._made_for,
            },
            friction_work=self.state.friction_work + self.model.copies * increment.friction_work,
        )

    def _give_up(self, strain: float, failure: Diverged) -> NotConverged:
        return NotConverged(
            f"no equilibrium at rope strain {strain:.6f}: {failure}; deepest contacts between yarns "
            f"{failure.deepest}; try a smaller steps.strain_increment, or contact.friction "
            "below 1"
        )
