"""Steps at a given rope strain: pull, hold and cycle, with increments of adaptive size."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..scene import Cycle, Hold, Pull
from .attempt import Attempt
from .model import RopeModel
from .outcome import Outcome
from .puller import Puller
from .state import State

SHALLOWER = 0.7  # share of the last slope that the next one is expected to have at least
LANDING = 0.002  # a force is reached when it is missed by less than this fraction


def hold(model: RopeModel, state: State, step: Hold) -> Iterator[Outcome]:
    """Keeps the strain for a number of increments, or until groups of ends are where they are wanted."""
    puller = Puller(model, state)
    done = int(state.progress.get("held", 0))
    while done < step.increments or not puller.grown(step):
        share = puller.next_share(step, step.increments - done)
        attempt = puller.to(puller.strain, share)
        done += 1
        puller.state = replace(puller.state, progress={**puller.state.progress, "held": done})
        yield outcome(puller, attempt, min(1.0, done / step.increments))


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
        aim = puller.strain + np.clip(end - puller.strain, -size, size)
        attempt = puller.to(aim, part=size / step.strain_increment)
        size = _next_size(size, attempt, step.strain_increment)
        puller.state = replace(puller.state, progress={**puller.state.progress, "size": size})
        last = abs(end - puller.strain) <= 1e-12
        share = (puller.strain - start) / (end - start)
        yield outcome(puller, attempt, share, f"{100 * end:g} % strain" if last else None)


def cycle(model: RopeModel, state: State, step: Cycle) -> Iterator[Outcome]:
    """Pulls to force_max and releases to force_min, time after time.

    Penalties that grow with the force do work on the rope. Here they fall with it as well, and take that work back:
    what a cycle costs is then friction.
    """
    puller = Puller(model, state)
    puller.eases = True
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
        attempt = puller.to(before + float(np.clip(wanted, -size, size)), part=size / nominal)
        change, force = puller.force() - force, puller.force()
        moved = puller.strain - before
        # A rope that slips in a small increment has not lost its stiffness: the next is longer, but not a whole one.
        slope = max(change / moved if moved else 0.0, SHALLOWER * slope)
        size = _next_size(size, attempt, nominal)
        puller.state = replace(
            puller.state, progress={**puller.state.progress, "size": size, "slope": slope}
        )
        # Passed by more, it stays so: a rope that slips goes back by another way.
        ended = sign * (force - target) > -LANDING * abs(target)
        share = 1.0 if ended else (force - first) / (target - first)
        yield outcome(puller, attempt, share, name if ended else None)
        if ended:
            return


def _next_size(size: float, attempt: Attempt, nominal: float) -> float:
    """Halved by cuts, doubled again up to the nominal size once increments succeed at once."""
    return size / 2 ** attempt.cuts if attempt.cuts else min(2 * size, nominal)


def outcome(puller: Puller, attempt: Attempt, share: float, snapshot: str | None = None) -> Outcome:
    """What an increment hands over, with how much of its step is done and the name of a state worth a picture."""
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
