"""What a step starts from: the start configuration, or a formed rope in its own model."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from mpi4py import MPI

from ..geometry import Rope, build_rope, rotations
from ..scene import Form, Scene
from .model import RopeModel, beam_body, cable_body, periodic_directors
from .state import State


def start_state(scene: Scene) -> State:
    """The start configuration: one pitch if it is to be formed, the whole rope as placed if not."""
    forms = isinstance(scene.steps[0], Form)
    rope = one_pitch(scene) if forms else build_rope(scene)
    q = np.concatenate(rope.centre_lines).ravel()
    elements = (len(rope.centre_lines[0]) - 1) // scene.yarn.degree * rope.num_yarns
    state = State(
        q=q,
        model="cell" if forms else "forming",
        reference=q.copy(),
        rest_tension=np.zeros(elements),
        rate=np.zeros_like(q),
    )
    return state if forms else in_own_model(scene, state)


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


def make_model(comm: MPI.Comm, scene: Scene, state: State) -> RopeModel:
    """The rope in the model that a state belongs to, with the state's contact history."""
    rope, symmetry = build_rope(scene), None
    if state.model == "cell":
        rope = one_pitch(scene)
        symmetry = rotations(rope)
        scene = replace(scene, ends=replace(scene.ends, transverse="periodic"))
    block = 9 if state.model == "beam" else 3
    reference = np.split(state.reference.reshape(-1, block)[:, :3], rope.num_yarns)
    body: Any
    if state.forms:
        # Material coordinates are those of the start, wherever nodes were spread to.
        body = cable_body(comm, scene, rope.centre_lines, 1.0, 0.0)
    elif state.model == "cable":
        body = cable_body(comm, scene, reference, scene.yarn.axial_stiffness, state.rest_tension)
    else:
        body = beam_body(comm, scene, reference, state.rest_tension)
    model = RopeModel(comm, scene, rope, body, symmetry)
    if state.forms:
        body.set_reference(state.reference.reshape(-1, block))
    else:
        density = state.rest_tension**2 / (2.0 * scene.yarn.axial_stiffness)
        model.preload_energy = float(density @ body.rest_lengths())
    model.contact.start = model.proximal.start = state.q
    if state.contacts:
        model.contact.restore_arrays(state.contacts)
    return model


def _with_directors(line: np.ndarray) -> np.ndarray:
    return np.hstack([line, periodic_directors(line).reshape(-1, 6)])


def _num_yarns(scene: Scene, state: State) -> int:
    nodes = scene.yarn.elements_per_pitch * scene.rope.pitches * scene.yarn.degree + 1
    return len(state.q) // (3 * nodes)


def one_pitch(scene: Scene) -> Rope:
    """One pitch of the start configuration."""
    return build_rope(replace(scene, rope=replace(scene.rope, pitches=1)))
