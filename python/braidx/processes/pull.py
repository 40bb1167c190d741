"""Steps at a given rope strain: settle, pull, hold and cycle, with increments of adaptive size."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..output.log import LOGGER
from ..scene import Cycle, Hold, Pull, Settle
from ..solver.increment import Diverged, Increment, IncrementOptions
from ..system.constraints import Floats
from .model import RopeModel
from .outcome import NotConverged, Outcome
from .state import State

LANDING = 0.002  # a force is reached when it is missed by less than this fraction
SETTLED = 0.05  # settled: the force is missed by less than this fraction (at zero force: yarns
UNSTRETCHED = 1e-6  # would be strained by less than this), and
REST = 1e-3  # the stabilisation's work in an increment, over the internal energy


@dataclass
class Attempt:
    """A solved increment and what all its attempts cost."""

    increment: Increment
    strain: float
    cuts: int
    iterations: int
    linear_solves: int


class Puller:
    """Goes from one rope strain to the next, cutting increments that fail."""

    def __init__(self, model: RopeModel, state: State) -> None:
        self.model, self.state = model, state
        self.strain = state.progress.get("strain", 0.0)
        scene = model.scene
        self._options = IncrementOptions(
            penetration=scene.contact.penetration_tolerance * model.rope.radius.min()
        )
        self._max_cuts = scene.solver.max_cuts
        self._stabilise(0)

    def to(self, strain: float) -> Attempt:
        """Solves for a strain, or for one on the way there if that increment has to be cut.

        Raises:
            NotConverged: If the smallest increment fails too.
        """
        cuts = iterations = solves = 0
        step = strain - self.strain
        while True:
            try:
                increment = self._increment(self.strain + step)
            except Diverged as failure:
                iterations, solves = iterations + failure.iterations, solves + failure.linear_solves
                cuts += 1
                LOGGER.warning("increment to strain %.5f cut: %s", self.strain + step, failure)
                if cuts > self._max_cuts:
                    raise self._give_up(self.strain + step, failure) from failure
                step /= 2
                self._stabilise(cuts)
                continue
            self._stabilise(0)
            self._take(increment, self.strain + step)
            return Attempt(
                increment,
                self.strain,
                cuts,
                iterations + increment.iterations,
                solves + increment.linear_solves,
            )

    def _stabilise(self, cuts: int) -> None:
        """Viscosity grows fourfold with every cut: a rope at rest cannot be helped by smaller steps."""
        solver = self.model.scene.solver
        factor = 4.0**cuts
        self.model.set_viscosity(factor * solver.viscosity, factor * solver.director_viscosity)

    def force(self) -> float:
        """Force on the rope now, N."""
        return self.model.axial_force(self.state.q)

    def _increment(self, strain: float) -> Increment:
        model = self.model
        system = model.system
        system.constraints, system.constraint_values = model.ends.held(strain)
        guess = system.expand(system.free_values(self._predict(strain)))
        return model.incrementer.solve(self.state.q, guess, self._options, self._stiffening(guess))

    def _stiffening(self, guess: Floats) -> float:
        """Growth of the yarns' mean tension beyond the largest so far, by the guess of the increment's end."""
        most = self.state.progress.get("tension", 0.0) or self._mean_tension(self.state.q)
        return max(1.0, self._mean_tension(guess) / most) if most > 0 else 1.0

    def _mean_tension(self, q: Floats) -> float:
        return float(np.mean(self.model.tension(q)))

    def _predict(self, strain: float) -> Floats:
        """The state stretched along the axis.

        Not at the rate of the last increment: how yarns slipped then is no guide to how they will.
        """
        moved = self.state.q.reshape(self.model.body.num_nodes, -1).copy()
        moved[:, 2] *= (1.0 + strain) / (1.0 + self.strain)
        return moved.ravel()

    def _take(self, increment: Increment, strain: float) -> None:
        self.strain = strain
        most = self.state.progress.get("tension", 0.0)
        tension = max(most, self._mean_tension(increment.q))
        self.state = replace(
            self.state,
            q=increment.q,
            contacts=self.model.contact.arrays(),
            progress={**self.state.progress, "strain": strain, "tension": tension},
            stabilisation_work=self.state.stabilisation_work + increment.stabilisation_work,
            friction_work=self.state.friction_work + increment.friction_work,
        )

    def _give_up(self, strain: float, failure: Diverged) -> NotConverged:
        pairs = ", ".join(f"{a}-{b}" for a, b in self.model.contact.worst_pairs())
        return NotConverged(
            f"no equilibrium at rope strain {strain:.6f}: {failure}; deepest contacts between yarns "
            f"{pairs or 'none'}; try a smaller steps.strain_increment, a higher solver.viscosity, or "
            "contact.friction below 1"
        )


def settle(model: RopeModel, state: State, step: Settle) -> Iterator[Outcome]:
    """Lets the rope come to rest at a force: until that is met and the stabilisation does no more work.

    The end is moved by what parallel yarns would need for the force that is missing.
    """
    done, wanted = int(state.progress.get("settled", 0)), 1e3 * step.force
    parallel = model.rope.num_yarns * model.scene.yarn.axial_stiffness
    near = max(SETTLED * wanted, UNSTRETCHED * parallel)
    puller = Puller(model, state)
    target = state.progress.get("target", puller.strain)
    while done < step.increments:
        attempt = puller.to(target)
        done += 1
        missing = wanted - puller.force()
        target = puller.strain + (missing / parallel if abs(missing) > near else 0.0)
        energy = max(model.internal_energy(puller.state.q), 1e-12)
        rest = attempt.increment.stabilisation_work < REST * energy and target == puller.strain
        done = step.increments if rest else done
        reached = {"settled": done, "target": target}
        puller.state = replace(
            puller.state,
            # On the way to rest the stabilisation works as it should: what counts is what it still does there.
            stabilisation_work=attempt.increment.stabilisation_work,
            progress={**puller.state.progress, **reached},
        )
        yield _outcome(
            puller, attempt, done / step.increments, "settled" if done == step.increments else None
        )


def hold(model: RopeModel, state: State, step: Hold) -> Iterator[Outcome]:
    """Keeps the strain for a number of increments."""
    puller = Puller(model, state)
    for done in range(int(state.progress.get("held", 0)) + 1, step.increments + 1):
        attempt = puller.to(puller.strain)
        puller.state = replace(puller.state, progress={**puller.state.progress, "held": done})
        yield _outcome(puller, attempt, done / step.increments)


def pull(model: RopeModel, state: State, step: Pull) -> Iterator[Outcome]:
    """Increases the strain until a force or a strain is reached."""
    puller = Puller(model, state)
    if step.to_force is not None:
        yield from _to_force(
            puller, 1e3 * step.to_force, step.strain_increment, f"{step.to_force:g} kN"
        )
        return
    assert step.to_strain is not None
    start, end = puller.strain, step.to_strain
    size = puller.state.progress.get("size", step.strain_increment)
    while abs(end - puller.strain) > 1e-12:
        attempt = puller.to(puller.strain + np.clip(end - puller.strain, -size, size))
        size = _next_size(size, attempt, step.strain_increment)
        puller.state = replace(puller.state, progress={**puller.state.progress, "size": size})
        last = abs(end - puller.strain) <= 1e-12
        share = (puller.strain - start) / (end - start)
        yield _outcome(puller, attempt, share, f"{100 * end:g} % strain" if last else None)


def cycle(model: RopeModel, state: State, step: Cycle) -> Iterator[Outcome]:
    """Pulls to force_max and releases to force_min, time after time."""
    puller = Puller(model, state)
    turns = 2 * step.cycles
    for turn in range(int(state.progress.get("turn", 0)), turns):
        target = step.force_min if turn % 2 else step.force_max
        for outcome in _to_force(
            puller, 1e3 * target, step.strain_increment, f"cycle {turn // 2 + 1}, {target:g} kN"
        ):
            ended = outcome.snapshot is not None
            puller.state = replace(
                outcome.state, progress={**outcome.state.progress, "turn": turn + ended}
            )
            yield replace(outcome, state=puller.state, share=(turn + outcome.share) / turns)


def _to_force(puller: Puller, target: float, nominal: float, name: str) -> Iterator[Outcome]:
    """Increments towards a force (N), the last ones by the slope of the curve so that it is met."""
    force = first = puller.force()
    size = puller.state.progress.get("size", nominal)
    slope = puller.state.progress.get("slope", 0.0)
    sign = 1.0 if target > force else -1.0
    while True:
        wanted = (target - force) / slope if slope > 0 else sign * size
        before = puller.strain
        attempt = puller.to(before + float(np.clip(wanted, -size, size)))
        change, force = puller.force() - force, puller.force()
        slope = max(change / (puller.strain - before), 0.0)
        size = _next_size(size, attempt, nominal)
        puller.state = replace(
            puller.state, progress={**puller.state.progress, "size": size, "slope": slope}
        )
        ended = abs(force - target) < LANDING * abs(target) or sign * (force - target) > 0.05 * abs(
            target
        )
        share = 1.0 if ended else (force - first) / (target - first)
        yield _outcome(puller, attempt, share, name if ended else None)
        if ended:
            return


def _next_size(size: float, attempt: Attempt, nominal: float) -> float:
    """Halved by cuts, doubled again up to the nominal size once increments succeed at once."""
    return size / 2 ** attempt.cuts if attempt.cuts else min(2 * size, nominal)


def _outcome(
    puller: Puller, attempt: Attempt, share: float, snapshot: str | None = None
) -> Outcome:
    return Outcome(
        puller.state,
        attempt.increment,
        share,
        puller.strain,
        puller.force(),
        attempt.cuts,
        (attempt.iterations, attempt.linear_solves),
        snapshot,
    )
