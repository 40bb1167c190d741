"""Steps of a rope over a sheave: bend, straighten, and again and again."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...output.log import LOGGER
from ...scene import Bend, BendCycles, Straighten
from ..attempt import Attempt
from ..outcome import Outcome
from ..state import State
from .auto import upgraded, upgrades, verdict
from .bender import Bender
from .model import BentRope
from .start import with_stretches

NEAR = 1e-9  # mm: a travel is reached
FRAMES = 10  # pictures on the way from one end of a travel to the other
WAY = "travel"  # name of these


def smooth_step(t: float) -> float:
    """From 0 to 1, slowly at both ends, where contacts close and open."""
    return 0.5 - 0.5 * math.cos(math.pi * t)


def bend(model: BentRope, state: State, step: Bend) -> Iterator[Outcome]:
    """Moves both ends towards the sheave."""
    bender = Bender(model, state)
    bender.pretension = 1e3 * step.pretension
    if not len(state.previous):
        # Yarns that were formed as tubes come to rest in their own model.
        yield _outcome(bender, bender.to(0.0), 0.0, "clamped")
    yield from _travel(bender, step.travel, step.increments, "bent")


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
    yield from _travel(Bender(model, state), 0.0, step.increments, "straightened")


def bend_cycles(model: BentRope, state: State, step: BendCycles) -> Iterator[Outcome]:
    """Straightens and bends again, as far as the rope has been bent before."""
    bender = Bender(model, state)
    furthest = state.progress["furthest"]
    turns = 2 * step.cycles
    for turn in range(int(state.progress.get("turn", 0)), turns):
        target, name = (furthest, "bent") if turn % 2 else (0.0, "straightened")
        for outcome in _travel(bender, target, step.increments, f"cycle {turn // 2 + 1}, {name}"):
            ended = abs(bender.travel - target) <= NEAR
            own = {**bender.state.progress, "turn": float(turn + ended)}
            bender.state = replace(bender.state, progress=own)
            yield replace(outcome, state=bender.state, share=(turn + outcome.share) / turns)


def _travel(bender: Bender, target: float, increments: int, name: str) -> Iterator[Outcome]:
    """Increments to a travel (mm) along a smooth step; one that is cut is made up for by more of them."""
    begin = bender.state.progress.get("begin", bender.travel)
    done = int(bender.state.progress.get("done", 0))
    while abs(target - bender.travel) > NEAR:
        aim = begin + smooth_step((done + 1) / increments) * (target - begin)
        attempt = bender.to(aim)
        done += abs(bender.travel - aim) < NEAR
        ended = abs(target - bender.travel) <= NEAR
        own = {"begin": target, "done": 0.0} if ended else {"begin": begin, "done": float(done)}
        if ended and target == 0.0:
            own |= _cycle(bender.state)
        bender.state = replace(bender.state, progress={**bender.state.progress, **own})
        share = (bender.travel - begin) / (target - begin)
        halted = name if ended else None
        if not ended and done % max(1, increments // FRAMES) == 0:
            halted = f"{WAY} {bender.travel:.1f} mm"
        yield _outcome(bender, attempt, share, halted)


def _cycle(state: State) -> dict[str, float]:
    """Friction work of the cycle that ends with a straight rope, and that at the beginning of the next, mJ."""
    before = state.progress.get("cycle_begin", 0.0)
    return {"cycle_work": state.friction_work - before, "cycle_begin": state.friction_work}


def _outcome(bender: Bender, attempt: Attempt, share: float, name: str | None) -> Outcome:
    model, state = bender.model, bender.state
    return Outcome(
        state,
        attempt.increment,
        share,
        None,
        float(np.abs(model.end_forces(state.q)).mean()),
        attempt.cuts,
        (attempt.iterations, attempt.linear_solves),
        name,
        travel=bender.travel,
    )
