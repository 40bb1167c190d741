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

FULL = (
    1e-3  # strain of the yarns, in the mean, from which on the stabilisation is what the scene says
)
SLACK = 1e-6  # mean strain below which yarns are slack
HELD = 3e-4  # work of the stabilisation over the energy that an increment of pulling may leave, and
HOLDABLE = 1e-3  # that it may where it cannot let go: all of a pull leave less than 1 % in the end
RESTS = 20  # increments at the same strain until then
UNBALANCED = 5e-3  # relative residual without the stabilisation that is left then, and
LOST = 0.04  # most of the energy that it may take on the way
HARD, EASY = 20, 8  # Newton iterations of an increment on the way to rest, and
CALM = 4.0  # factor on the stabilisation then, and
CALMEST = 4.0**-4  # the least that it becomes
IN_VAIN = 15  # contact updates in a row that come no nearer; of increments that are found most take less than 10
LEAST_ENERGY = 1e-12  # mJ; slack yarns have none
EASED = 0.1  # least share of themselves that penalties fall to in an increment
LEAST = 0.01  # share of it that is left where yarns are slack
BENT = 1e-3  # of a yarn radius: distance from rigid that is left to a group of ends
TURNS = 8  # repetitions of an increment in which bodies turn on
GROWN = 1e-9  # what groups of ends are to reach is missed by less than this share


class Puller:
    """Goes from one rope strain to the next, cutting increments that fail.

    Attributes:
        strain: Rope strain of the state.
        share: What is reached of what groups of ends ask for, 0 to 1.
        calming: Factor on the stabilisation that the scene asks for.
        releases: Whether the stabilisation lets go of states found.
        rests: Whether a rope that it cannot let go of comes to rest, at the strain that it is pulled to.
        eases: Whether penalties fall with the tension of yarns, too, and do not only rise with it.
    """

    def __init__(self, model: RopeModel, state: State) -> None:
        self.model, self.state = model, state
        self.strain = state.progress.get("strain", 0.0)
        self.share = state.progress.get("share", 0.0)
        self.calming = state.progress.get("calming", 1.0)
        self.releases = True
        self.rests = True
        self.eases = False
        # Mean tension of the yarns that penalties are made for: they go with what is expected of increments.
        self._made_for = state.progress.get("tension", 0.0) or self._mean_tension(state.q)
        self._expected = self._made_for
        scene = model.scene
        penetration = scene.contact.penetration_tolerance * model.rope.radius.min()
        self._options = IncrementOptions(
            penetration=penetration, most_in_vain=IN_VAIN, may_hold=True
        )
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
            self._stabilise(cuts)
            return self._found(self.strain + fraction * step, self.share + fraction * growth)

        done = attempt(
            solve,
            lambda fraction: f"strain {self.strain + fraction * step:.5f}",
            self._cuts_left(part),
            lambda fraction, failure: self._give_up(self.strain + fraction * step, failure),
        )
        part = done.fraction
        self._take(done.increment, self.strain + part * step, self.share + part * growth)
        return done

    @property
    def _stuck(self) -> bool:
        """Whether the stabilisation could not let go of a state of this step."""
        return bool(self.state.progress.get("stuck", 0.0))

    def held_share(self, increment: Increment) -> float:
        """Work of the stabilisation over the internal energy."""
        energy = self.model.internal_energy(increment.q)
        return increment.stabilisation_residual / max(energy, LEAST_ENERGY)

    def calm(self, iterations: int) -> None:
        """More stabilisation for a rope that is found with pains, less, and more way to go, for one found with ease."""
        if iterations > HARD:
            self.calming *= CALM
        elif iterations < EASY:
            self.calming = max(self.calming / CALM, CALMEST)

    def _found(self, strain: float, share: float) -> Increment:
        """The rope at a strain, at rest there even where the stabilisation cannot let go of it."""
        if not self.rests:
            return self._increment(strain, share)
        before = self.model.contact.elements.copy()
        found = self._increment(strain, share)
        if not (found.held or self._stuck):
            return found
        try:
            return self._rested(found, strain, share)
        except Diverged:
            self.model.contact.restore(before)
            raise

    def _rested(self, found: Increment, strain: float, share: float) -> Increment:
        """Further increments at the same strain, each held from where the last one was found, until little is held.

        Args:
            found: The first one, from the present state.
            strain, share: Where it led to.
        Returns:
            All of them as one.
        Raises:
            Diverged: If the rope does not come to rest, or gives way by more than may be lost to the stabilisation.
        """
        kept = self.state, self.strain, self.share, self.calming, self._made_for
        stuck, lost = {**self.state.progress, "stuck": 1.0}, self.held_share(found)
        try:
            for _ in range(RESTS):
                if self.is_at_rest(found):
                    return found
                self.state = replace(self.state, q=found.q, progress=stuck)
                self.strain, self.share, self._made_for = strain, share, self._expected
                self._stabilise(0)
                last = self._increment(strain, share)
                lost += self.held_share(last)
                if lost > LOST:
                    raise Diverged(f"{100.0 * lost:.0f} % of the energy is lost at rest", 0, 0)
                self.calm(last.iterations)
                found = replace(
                    last,
                    held=True,
                    iterations=found.iterations + last.iterations,
                    linear_solves=found.linear_solves + last.linear_solves,
                    stabilisation_work=found.stabilisation_work + last.stabilisation_work,
                    friction_work=found.friction_work + last.friction_work,
                )
            raise Diverged("the rope does not come to rest", found.iterations, found.linear_solves)
        finally:
            self.state, self.strain, self.share, self.calming, self._made_for = kept

    def is_at_rest(self, found: Increment) -> bool:
        """Whether the stabilisation does little work, and its forces are small beside the others."""
        self.model.proximal.start = found.q
        unbalanced = self.model.newton.residual(found.q)
        return self.held_share(found) < HOLDABLE and unbalanced < UNBALANCED

    def _cuts_left(self, part: float) -> int:
        most = self.model.scene.solver.max_cuts
        return int(np.clip(2 * most + np.log2(part), 0, most))

    def _stabilise(self, cuts: int) -> None:
        """Less at small tensions, which it must not outweigh; fourfold with every cut, since smaller steps alone
        cannot help a rope at rest.
        """
        scene = self.model.scene
        solver, strain = scene.solver, self._mean_tension(self.state.q) / scene.yarn.axial_stiffness
        share = self.calming * min(max(strain / FULL, LEAST), 1.0)
        factor = 4.0**cuts * max(share, LEAST)
        self.model.set_viscosity(factor * solver.viscosity, factor * solver.director_viscosity)

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
        first = system.expand(system.free_values(placed))
        least = EASED if self.eases else 1.0
        self._expected = max(self._mean_tension(first), least * self._made_for)
        slack = self._made_for < SLACK * model.scene.yarn.axial_stiffness
        stiffening = 1.0 if slack else self._expected / self._made_for
        lets_go = self.releases and not (self.rests and self._stuck)
        most = HELD * model.internal_energy(first) if lets_go else None
        options = replace(self._options, stabilisation=most)
        return model.incrementer.solve(self.state.q, first, options, stiffening)

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
                "stuck": max(before.get("stuck", 0.0), float(increment.held)),
            },
            stabilisation_work=self.state.stabilisation_work + increment.stabilisation_work,
            stabilisation_residual=self.state.stabilisation_residual
            + increment.stabilisation_residual,
            friction_work=self.state.friction_work + self.model.copies * increment.friction_work,
        )

    def _give_up(self, strain: float, failure: Diverged) -> NotConverged:
        return NotConverged(
            f"no equilibrium at rope strain {strain:.6f}: {failure}; deepest contacts between yarns "
            f"{failure.deepest}; try a smaller steps.strain_increment, a higher solver.viscosity, or "
            "contact.friction below 1"
        )
