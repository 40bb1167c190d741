"""Steps of a rope over a sheave: pull, bend, run over it, straighten, and again and again."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...output.log import LOGGER
from ...scene import Bend, BendCycles, Pull, RunOver, Straighten
from ..attempt import Attempt
from ..outcome import Outcome
from ..state import State
from .auto import upgraded, upgrades, verdict
from .bender import Bender
from .ends import Ends
from .model import BentRope
from .start import with_stretches

NEAR = 1e-9  # mm, or N: what is asked for is reached
FRAMES = 10  # pictures on the way from one end of a travel to the other
WAY = "travel"  # name of these


def smooth_step(t: float) -> float:
    """From 0 to 1, slowly at both ends, where contacts close and open."""
    return 0.5 - 0.5 * math.cos(math.pi * t)


def pull(model: BentRope, state: State, step: Pull) -> Iterator[Outcome]:
    """Raises or lowers the force on the straight rope."""
    bender = Bender(model, state)
    assert step.to_force is not None
    yield from _clamped(bender)
    aim = replace(bender.ends, pull=1e3 * step.to_force)
    rigid = len(model.lines) * model.scene.yarn.axial_stiffness
    change = abs(aim.pull - bender.ends.pull) / (rigid * step.strain_increment)
    increments = max(1, math.ceil(change))
    yield from _move(bender, aim, increments, f"{step.to_force:g} kN", evenly=True)


def bend(model: BentRope, state: State, step: Bend) -> Iterator[Outcome]:
    """Moves both ends towards the sheave."""
    bender = Bender(model, state)
    if step.pretension is not None:
        bender.ends = replace(bender.ends, pull=1e3 * step.pretension)
    yield from _clamped(bender)
    aim = replace(bender.ends, travel=step.travel)
    yield from _move(bender, aim, step.increments, "bent")


def improved(model: BentRope, state: State) -> State | None:
    """The rope straight again, with better models where those it was bent with do not suffice; None where they do."""
    yarn = model.scene.yarn
    if "auto" not in (yarn.model_of(number) for number in range(len(model.lines))):
        return None
    picture = model.picture(state, "bent")
    changes = upgrades(model, picture)
    if not changes:
        LOGGER.info("models suffice: %s", verdict(model, picture))
        return None
    for change in changes:
        LOGGER.info("better model: %s", change)
    LOGGER.info("%d stretches get better models; the rope is bent again", len(changes))
    return with_stretches(state, upgraded(model, changes))


def straighten(model: BentRope, state: State, step: Straighten) -> Iterator[Outcome]:
    """Moves both ends back."""
    bender = Bender(model, state)
    yield from _move(bender, replace(bender.ends, travel=0.0), step.increments, "straightened")


def bend_cycles(model: BentRope, state: State, step: BendCycles) -> Iterator[Outcome]:
    """Straightens and bends again, as far as the rope has been bent before."""
    bender = Bender(model, state)
    furthest = state.progress["furthest"]
    legs = [
        (replace(bender.ends, travel=travel), step.increments, f"cycle {cycle + 1}, {name}")
        for cycle in range(step.cycles)
        for travel, name in ((0.0, "straightened"), (furthest, "bent"))
    ]
    yield from _legs(bender, legs)


def run_over(model: BentRope, state: State, step: RunOver) -> Iterator[Outcome]:
    """Draws the rope over the sheave, to one side, to the other and back."""
    bender = Bender(model, state)
    ends = bender.ends
    if "leg" not in state.progress:
        ends = bender.ends = replace(ends, slope=model.slope(state.q))
    legs = [
        (replace(ends, run=run), count * step.increments, f"run {cycle + 1}, {name}")
        for cycle in range(step.cycles)
        for run, count, name in ((step.way, 1, "to"), (-step.way, 2, "fro"), (0.0, 1, "back"))
    ]
    yield from _legs(bender, legs)


def _clamped(bender: Bender) -> Iterator[Outcome]:
    """Yarns that were formed as tubes are brought into equilibrium in their own model."""
    if not len(bender.state.previous):
        yield _outcome(bender, bender.to(bender.ends), 0.0, "clamped")


def _legs(bender: Bender, legs: list[tuple[Ends, int, str]]) -> Iterator[Outcome]:
    """One motion after the other; a run that is resumed goes on with the one that it was at."""
    for leg in range(int(bender.state.progress.get("leg", 0)), len(legs)):
        for outcome in _move(bender, *legs[leg]):
            ended = outcome.snapshot == legs[leg][2]
            own = {**bender.state.progress, "leg": float(leg + ended)}
            bender.state = replace(bender.state, progress=own)
            share = (leg + outcome.share) / len(legs)
            yield replace(outcome, state=bender.state, share=share)


def _move(
    bender: Bender, aim: Ends, increments: int, name: str, evenly: bool = False
) -> Iterator[Outcome]:
    """Increments to an aim along a smooth step, or evenly; one that is cut is made up for by more of them."""
    progress = bender.state.progress
    begin = Ends.reached({key[6:]: progress[key] for key in progress if key.startswith("begin_")})
    done = int(progress.get("done", 0))
    if not done and "begin_travel" not in progress:
        begin = bender.ends
    begin = replace(begin, slope=aim.slope)
    size = float(np.abs(aim.parts - begin.parts).sum())
    while (left := float(np.abs(aim.parts - bender.ends.parts).sum())) > NEAR:
        share = (done + 1) / increments
        next_one = begin.towards(aim, share if evenly else smooth_step(share))
        attempt = bender.to(next_one)
        left = float(np.abs(aim.parts - bender.ends.parts).sum())
        done += float(np.abs(next_one.parts - bender.ends.parts).sum()) < NEAR
        ended = left <= NEAR
        own = {f"begin_{key}": value for key, value in begin.progress().items()}
        state = bender.state.progress
        kept = {key: value for key, value in state.items() if not key.startswith("begin_")}
        kept |= {"done": 0.0} if ended else {"done": float(done), **own}
        if ended and aim.travel == aim.run == 0.0 and begin.parts[[0, 2]].any():
            kept |= _cycle(bender.state)
        bender.state = replace(bender.state, progress=kept)
        halted = name if ended else None
        if not ended and aim.travel != begin.travel and done % max(1, increments // FRAMES) == 0:
            halted = f"{WAY} {bender.ends.travel:.1f} mm"
        yield _outcome(bender, attempt, 1.0 - left / size, halted)


def _cycle(state: State) -> dict[str, float]:
    """Friction work of the cycle that ends, and that at the beginning of the next, mJ."""
    before = state.progress.get("cycle_begin", 0.0)
    return {"cycle_work": state.friction_work - before, "cycle_begin": state.friction_work}


def _outcome(bender: Bender, attempt: Attempt, share: float, name: str | None) -> Outcome:
    model, state, ends = bender.model, bender.state, bender.ends
    straight = ends.travel == 0.0
    towards = float(np.abs(model.end_forces(state.q)).mean())
    return Outcome(
        state,
        attempt.increment,
        share,
        model.strain(state.q) if straight else None,
        ends.pull if straight and ends.pull else towards,
        attempt.cuts,
        (attempt.iterations, attempt.linear_solves),
        name,
        travel=ends.travel,
        run=ends.run,
    )
