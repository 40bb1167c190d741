"""What a step starts from: the start configuration, or a formed rope in its own model."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from mpi4py import MPI

from ..geometry import (
    Rope,
    Rotations,
    build_rope,
    no_rotations,
    one_for_all,
    one_pitch,
    rotation_about_z,
    rotations,
)
from ..scene import Form, Scene
from ..system.constraints import Floats
from .end_nodes import EndNodes
from .ends import Ends
from .form import keeps_lengths
from .grouped_ends import GroupedEnds
from .model import RopeModel, beam_body, cable_body, periodic_directors
from .state import CELL, State


def start_state(scene: Scene) -> State:
    """The start configuration: one pitch if it is to be formed, the whole rope as placed if not."""
    forms = isinstance(scene.steps[0], Form)
    rope = one_pitch(scene) if forms or one_for_all(scene) else build_rope(scene)
    q = np.concatenate(rope.centre_lines).ravel()
    elements = (len(rope.centre_lines[0]) - 1) // scene.yarn.degree * rope.num_yarns
    state = State(
        q=q,
        model="cell" if forms else "forming",
        reference=q.copy(),
        rest_tension=np.zeros(elements),
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
    q = _with_directors(scene, state.q) if scene.yarn.model == "beam" else state.q
    return replace(
        state,
        model=scene.yarn.model,
        q=q,
        reference=q.copy(),
        rest_tension=scale * state.rest_tension,
        contacts=contacts,
        stabilisation_work=0.0,
        progress={},
    )


def make_model(comm: MPI.Comm, scene: Scene, state: State) -> RopeModel:
    """The rope in the model that a state belongs to, with the state's contact history."""
    rope = one_pitch(scene) if state.model in CELL or one_for_all(scene) else build_rope(scene)
    block = 9 if state.model == "beam" else 3
    reference = np.split(state.reference.reshape(-1, block), rope.num_yarns)
    body: Any
    if state.forms:
        # Material coordinates are those of the start, wherever nodes were spread to.
        body = cable_body(comm, scene, rope.centre_lines, 1.0, 0.0)
    elif state.model == "cable":
        body = cable_body(comm, scene, reference, scene.yarn.axial_stiffness, state.rest_tension)
    else:
        body = beam_body(comm, scene, reference, state.rest_tension)
    model = RopeModel(comm, scene, rope, body, _ends(scene, rope, body, state))
    if state.forms:
        body.set_reference(state.reference.reshape(-1, block))
    else:
        density = state.rest_tension**2 / (2.0 * scene.yarn.axial_stiffness)
        model.preload_energy = float(density @ body.rest_lengths())
    model.contact.start = model.proximal.start = state.q
    if state.contacts:
        model.contact.restore_arrays(state.contacts)
    return model


def _with_directors(scene: Scene, positions: Floats) -> Floats:
    """Positions and directors; those of an image are turned with it."""
    symmetry = _symmetry(scene, build_rope(scene))
    lines = np.split(positions.reshape(-1, 3), len(symmetry.leader))
    angles = 2.0 * np.pi * symmetry.turns / symmetry.fold
    parts = [
        np.hstack(
            [line, (periodic_directors(lines[leader]) @ rotation_about_z(angle)).reshape(-1, 6)]
        )
        for line, leader, angle in zip(lines, symmetry.leader, angles, strict=True)
    ]
    return np.concatenate(parts).ravel()


def _symmetry(scene: Scene, rope: Rope) -> Rotations:
    return rotations(rope) if scene.solver.symmetry else no_rotations(rope)


def _ends(scene: Scene, rope: Rope, body: Any, state: State) -> Ends | GroupedEnds:
    """What is held: the ends of one pitch are alike; then those of the whole rope as the scene says.

    Groups of ends act once the rope is formed; until then the ends are alike. They need not be symmetric, and the
    rope then is not kept so.
    """
    if scene.ends.groups and not state.forms:
        nodes = EndNodes(body.block, body.layout.curves, state.reference)
        return GroupedEnds(nodes, scene.ends, rope)
    symmetry = _symmetry(scene, rope)
    pulled = state.forms and keeps_lengths(scene, state)
    alike = replace(scene.ends, transverse="periodic", groups=())
    if state.model in CELL:
        # While nodes are spread along yarns, planes tell where the material is.
        return Ends(body, alike, symmetry, state.q, pulled=pulled, planar=state.model == "cell")
    ends = alike if scene.ends.groups else scene.ends
    at = state.q if state.forms else state.reference
    return Ends(body, ends, symmetry, at, pulled=pulled, cut=bool(scene.ends.groups))
