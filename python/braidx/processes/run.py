"""A run: the steps of a scene one after the other, recorded after every increment, resumable."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from mpi4py import MPI

from ..geometry import build_rope
from ..output.log import LOGGER
from ..output.summary import PhaseCost
from ..scene.effects import bends
from ..scene import (
    Bend,
    BendCycles,
    Cycle,
    Form,
    Hold,
    Pull,
    RunOver,
    Scene,
    Settle,
    Step,
    Straighten,
)
from . import state as checkpoint
from .bending.bend import bend, bend_cycles, improved, run_over, straighten
from .bending.bend import pull as pull_clamped
from .bending.model import BentRope
from .bending.solids import check_core
from .bending.start import BENT, clamped, make_bent_rope
from .form import form
from .grouped_ends import check_ends
from .model import RopeModel
from .outcome import NotConverged, Outcome
from .pull import cycle, hold, pull
from .settle import settle
from .recorder import Recorder
from .pitches import next_stage
from .start import in_own_model, make_model, start_state
from .state import State

STEPS: dict[type[Step], Callable[..., Iterator[Outcome]]] = {
    Form: form,
    Settle: settle,
    Pull: pull,
    Hold: hold,
    Cycle: cycle,
    Bend: bend,
    Straighten: straighten,
    BendCycles: bend_cycles,
    RunOver: run_over,
}
PULL_CLAMPED: Callable[..., Iterator[Outcome]] = (
    pull_clamped  # of a rope that is bent in the same scene
)
REST_FORCE = 100.0  # force on the rope after forming where no settle step gives one, N


def run(scene: Scene, folder: Path, resume: bool = False) -> dict[str, Any]:
    """Computes a scene into an existing folder.

    Args:
        scene: The scene, checked.
        folder: Output folder.
        resume: Go on from the folder's last checkpoint.
    Returns:
        The contents of summary.json.
    Raises:
        NotConverged: If a step finds no equilibrium, or the stabilisation did more work than results may have in
            them; what was reached is in the folder.
    """
    comm = MPI.COMM_WORLD
    rope = build_rope(scene)
    check_ends(scene, rope)
    check_core(scene)
    state = checkpoint.load(folder) if resume else None
    recorder = Recorder(comm, scene, rope, folder, state)
    try:
        _run_steps(comm, scene, state or start_state(scene), recorder)
    except NotConverged as failure:
        LOGGER.error("%s", failure)
        recorder.finish(converged=False)
        raise
    return recorder.finish(converged=True)


def _run_steps(comm: MPI.Comm, scene: Scene, state: State, recorder: Recorder) -> None:
    model: RopeModel | BentRope | None = None
    is_bent = bends(scene)
    while state.step < len(scene.steps):
        step = scene.steps[state.step]
        if is_bent and not isinstance(step, Form) and state.model != BENT:
            state, model = clamped(scene, state), None
        elif state.forms and not isinstance(step, Form):
            force = 1e3 * step.force if isinstance(step, Settle) else REST_FORCE
            state = in_own_model(scene, state, force, state.results.get("formed_force", 0.0))
            model = None
        if model is None and state.model == BENT:
            model, state = make_bent_rope(comm, scene, state)
        elif model is None:
            model = make_model(comm, scene, state)
        recorder.begin(step, model)
        clock = time.perf_counter()
        follow = PULL_CLAMPED if is_bent and isinstance(step, Pull) else STEPS[type(step)]
        for outcome in _named(follow(model, state, step), state.increment):
            seconds = time.perf_counter() - clock
            state = _counted(outcome, state, step, seconds)
            recorder.record(model, step, replace(outcome, state=state), seconds)
            clock = time.perf_counter()
        following = _once_more(model, state, step)
        model = None if following else model
        state = following or state.next_step()
        recorder.checkpoint(state)


def _once_more(model: RopeModel | BentRope, state: State, step: Step) -> State | None:
    """What a step goes on from before the next one's turn comes; None at its end."""
    if isinstance(model, RopeModel):
        return next_stage(model, state)
    return improved(model, state) if isinstance(step, Bend) else None


def _named(outcomes: Iterator[Outcome], done: int) -> Iterator[Outcome]:
    """The outcomes of a step; a failure tells at which increment of the run it happened."""
    try:
        for outcome in outcomes:
            done += 1
            yield outcome
    except NotConverged as failure:
        raise NotConverged(f"increment {done + 1}: {failure}") from failure


def _counted(outcome: Outcome, before: State, step: Step, seconds: float) -> State:
    """The outcome's state with the run's increment number and cost."""
    cost = before.costs.get(step.kind, PhaseCost())
    cost = PhaseCost(
        cost.seconds + seconds,
        cost.increments + 1,
        cost.newton_iterations + outcome.cost[0],
        cost.linear_solves + outcome.cost[1],
    )
    return replace(
        outcome.state,
        step=before.step,
        increment=before.increment + 1,
        costs={**before.costs, step.kind: cost},
        results=(
            {**before.results, "formed_force": outcome.force}
            if isinstance(step, Form)
            else before.results
        ),
    )
