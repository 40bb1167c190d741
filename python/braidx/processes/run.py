"""A run: the steps of a scene one after the other, recorded after every increment, resumable."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from mpi4py import MPI

from ..geometry import Rope, build_rope
from ..output.log import LOGGER
from ..output.summary import PhaseCost
from ..scene import Cycle, Form, Hold, Pull, Scene, Settle, Step
from . import state as checkpoint
from .form import form
from .model import RopeModel, beam_body, cable_body, periodic_directors
from .outcome import NotConverged, Outcome
from .pull import cycle, hold, pull, settle
from .recorder import Recorder
from .state import State

STEPS: dict[type[Step], Callable[..., Iterator[Outcome]]] = {
    Form: form,
    Settle: settle,
    Pull: pull,
    Hold: hold,
    Cycle: cycle,
}
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
        NotConverged: If a step finds no equilibrium; what was reached is in the folder.
    """
    comm = MPI.COMM_WORLD
    rope = build_rope(scene)
    state = checkpoint.load(folder) if resume else None
    recorder = Recorder(comm, scene, rope, folder, state)
    state = state or start_state(scene, rope)
    try:
        state = _run_steps(comm, scene, rope, state, recorder)
    except NotConverged as failure:
        LOGGER.error("%s", failure)
        recorder.finish(converged=False)
        raise
    return recorder.finish(converged=True)


def start_state(scene: Scene, rope: Rope) -> State:
    """The start configuration; a scene that forms nothing starts with straight-away yarns as placed."""
    q = np.concatenate(rope.centre_lines).ravel()
    tension = np.zeros((len(rope.centre_lines[0]) - 1) // scene.yarn.degree * rope.num_yarns)
    state = State(
        q=q, model="forming", reference=q.copy(), rest_tension=tension, rate=np.zeros_like(q)
    )
    return state if isinstance(scene.steps[0], Form) else in_own_model(scene, state)


def in_own_model(scene: Scene, state: State, force: float = 0.0, axial_force: float = 0.0) -> State:
    """A formed rope in the scene's own model of the yarns.

    Its shape becomes the reference. Tensions and contact forces of forming are scaled to a small force on the
    rope, together: it stays in equilibrium.

    Args:
        scene: The scene.
        state: State at the end of forming.
        force: Force wanted on the rope, N.
        axial_force: Force on the rope at the end of forming, N.
    """
    scale = force / axial_force if axial_force > 0 else 1.0
    contacts = dict(state.contacts)
    if contacts:
        contacts["stiffness"] = scale * contacts["stiffness"]
        contacts["slip"] = 0.0 * contacts["slip"]
    q = state.q
    if scene.yarn.model == "beam":
        lines = np.split(q.reshape(-1, 3), _num_yarns(scene, state))
        q = np.concatenate([_with_directors(line) for line in lines]).ravel()
    return replace(
        state,
        model=scene.yarn.model,
        q=q,
        reference=q.copy(),
        rest_tension=scale * state.rest_tension,
        rate=np.zeros_like(q),
        contacts=contacts,
        stabilisation_work=0.0,
        progress={},
    )


def make_model(comm: MPI.Comm, scene: Scene, rope: Rope, state: State) -> RopeModel:
    """The rope in the model that a state belongs to, with the state's contact history."""
    block = 9 if state.model == "beam" else 3
    reference = np.split(state.reference.reshape(-1, block)[:, :3], rope.num_yarns)
    body: Any
    if state.model == "forming":
        # Material coordinates are those of the start, wherever nodes were spread to.
        body = cable_body(comm, scene, rope.centre_lines, 1.0, 0.0)
    elif state.model == "cable":
        body = cable_body(comm, scene, reference, scene.yarn.axial_stiffness, state.rest_tension)
    else:
        body = beam_body(comm, scene, reference)
    model = RopeModel(comm, scene, rope, body)
    if state.model == "forming":
        body.set_reference(state.reference.reshape(-1, block))
    model.contact.start = model.proximal.start = state.q
    if state.contacts:
        model.contact.restore_arrays(state.contacts)
    return model


def _run_steps(comm: MPI.Comm, scene: Scene, rope: Rope, state: State, recorder: Recorder) -> State:
    model: RopeModel | None = None
    while state.step < len(scene.steps):
        step = scene.steps[state.step]
        if state.model == "forming" and not isinstance(step, Form):
            force = 1e3 * step.force if isinstance(step, Settle) else REST_FORCE
            state = in_own_model(scene, state, force, state.results.get("formed_force", 0.0))
            model = None
        if model is None:
            model = make_model(comm, scene, rope, state)
        recorder.begin(step, model)
        clock = time.perf_counter()
        for outcome in _named(STEPS[type(step)](model, state, step), state.increment):
            seconds = time.perf_counter() - clock
            state = _counted(outcome, state, step, seconds)
            recorder.record(model, step, replace(outcome, state=state), seconds)
            clock = time.perf_counter()
        state = state.next_step()
        recorder.checkpoint(state)
    return state


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


def _with_directors(line: np.ndarray) -> np.ndarray:
    return np.hstack([line, periodic_directors(line).reshape(-1, 6)])


def _num_yarns(scene: Scene, state: State) -> int:
    nodes = scene.yarn.elements_per_pitch * scene.rope.pitches * scene.yarn.degree + 1
    return len(state.q) // (3 * nodes)
