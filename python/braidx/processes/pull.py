"""Steps at a given rope strain: settle, pull, hold and cycle, with increments of adaptive size."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..scene import Cycle, Hold, Pull, Settle
from .model import RopeModel
from .outcome import Outcome
from .puller import Attempt, Puller
from .state import State

LANDING = 0.002  # a force is reached when it is missed by less than this fraction
SETTLED = 0.05  # settled: the force is missed by less than this fraction (at zero force: yarns
UNSTRETCHED = 1e-6  # would be strained by less than this), and
STRIDES = 4.0  # most of what parallel yarns would need that the end is moved by
HARD, EASY = 20, 8  # Newton iterations of an increment on the way to rest, and
CALM = 4.0  # factor on the stabilisation then, and
LEAST = 4.0**-4  # the least that it becomes
REST = 1e-3  # the stabilisation's work in an increment, over the internal energy


def settle(model: RopeModel, state: State, step: Settle) -> Iterator[Outcome]:
    """Lets the rope come to rest at a force: until that is met and the stabilisation does no more work.

    The end is moved by what parallel yarns would need for the force that is missing, and by more and more of it while
    the rope gives way.
    """
    done, wanted = int(state.progress.get("settled", 0)), 1e3 * step.force
    parallel = model.rope.num_yarns * model.scene.yarn.axial_stiffness
    near = max(SETTLED * wanted, UNSTRETCHED * parallel)
    puller = Puller(model, state)
    puller.releases = False
    target = state.progress.get("target", puller.strain)
    missing, stride = state.progress.get("missing", 0.0), state.progress.get("stride", 1.0)
    while done < step.increments or not puller.grown(step):
        # Groups of ends have half of the increments to get where they are wanted.
        share = puller.next_share(step, (step.increments + 1) // 2 - done)
        attempt = puller.to(target, share)
        done += 1
        before, missing = missing, wanted - puller.force()
        stride = min(2 * stride, STRIDES) if 0.5 * before**2 < missing * before else 1.0
        target = puller.strain + (stride * missing / parallel if abs(missing) > near else 0.0)
        energy = max(model.internal_energy(puller.state.q), 1e-12)
        rest = attempt.increment.stabilisation_work < REST * energy and target == puller.strain
        rest = rest and puller.calming <= 1.0
        done = step.increments if rest and puller.grown(step) else done
        puller.calming = _next_calming(puller.calming, attempt.iterations)
        if done >= step.increments - 1:  # the last one is to be at rest
            puller.calming = min(puller.calming, 1.0)
        reached = {
            "settled": done,
            "target": target,
            "calming": puller.calming,
            "missing": missing,
            "stride": stride,
        }
        puller.state = replace(
            puller.state,
            # On the way to rest the stabilisation works as it should: what counts is what it still does there.
            stabilisation_work=attempt.increment.stabilisation_work,
            progress={**puller.state.progress, **reached},
        )
        ended = done >= step.increments and puller.grown(step)
        yield _outcome(
            puller, attempt, min(1.0, done / step.increments), "settled" if ended else None
        )


def hold(model: RopeModel, state: State, step: Hold) -> Iterator[Outcome]:
    """Keeps the strain for a number of increments, or until groups of ends are where they are wanted."""
    puller = Puller(model, state)
    done = int(state.progress.get("held", 0))
    while done < step.increments or not puller.grown(step):
        share = puller.next_share(step, step.increments - done)
        attempt = puller.to(puller.strain, share)
        done += 1
        puller.state = replace(puller.state, progress={**puller.state.progress, "held": done})
        yield _outcome(puller, attempt, min(1.0, done / step.increments))


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
        moved = puller.strain - before
        slope = max(change / moved, 0.0) if moved else 0.0
        size = _next_size(size, attempt, nominal)
        puller.state = replace(
            puller.state, progress={**puller.state.progress, "size": size, "slope": slope}
        )
        # Passed by more, it stays so: a rope that slips goes back by another way.
        ended = sign * (force - target) > -LANDING * abs(target)
        share = 1.0 if ended else (force - first) / (target - first)
        yield _outcome(puller, attempt, share, name if ended else None)
        if ended:
            return


def _next_size(size: float, attempt: Attempt, nominal: float) -> float:
    """Halved by cuts, doubled again up to the nominal size once increments succeed at once."""
    return size / 2 ** attempt.cuts if attempt.cuts else min(2 * size, nominal)


def _next_calming(calming: float, iterations: int) -> float:
    """More stabilisation for a rope that is found with pains, less, and more way to go, for one found with ease."""
    if iterations > HARD:
        return CALM * calming
    return max(calming / CALM, LEAST) if iterations < EASY else calming


def _outcome(
    puller: Puller, attempt: Attempt, share: float, snapshot: str | None = None
) -> Outcome:
    model, state = puller.model, puller.state
    return Outcome(
        state,
        attempt.increment,
        share,
        model.ends.strain(state.q, puller.strain),
        puller.force(),
        attempt.cuts,
        (attempt.iterations, attempt.linear_solves),
        snapshot,
        model.axial_moment(state.q) if model.ends.grouped else None,
    )
