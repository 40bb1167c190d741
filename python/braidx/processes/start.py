"""What a step starts from: the start configuration, or a formed rope in its own model."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from mpi4py import MPI

from ..geometry import Rope, build_rope, one_for_all, one_pitch
from ..scene import Form, Scene
from ..system.constraints import Floats
from .directors import formed_with_beams, symmetry_of, with_directors
from .end_nodes import EndNodes
from .ends import Ends
from .form import keeps_lengths
from .grouped_ends import GroupedEnds
from .model import RopeModel
from .state import CELL, State, restore_contacts
from .yarns import beam_body, cable_body


def start_state(scene: Scene) -> State:
    """The start configuration: one pitch if it is to be formed, the whole rope as placed if not."""
    forms = isinstance(scene.steps[0], Form)
    rope = one_pitch(scene) if forms or one_for_all(scene) else build_rope(scene)
    q: Floats = np.concatenate(rope.centre_lines).ravel()
    q = with_directors(scene, q) if formed_with_beams(scene) else q
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
    q = state.q
    if formed_with_beams(scene) and scene.yarn.model == "cable":
        q = q.reshape(-1, 9)[:, :3].ravel()
    elif not formed_with_beams(scene) and scene.yarn.model == "beam":
        q = with_directors(scene, q)
    return replace(
        state,
        model=scene.yarn.model,
        q=q,
        reference=q.copy(),
        rest_tension=scale * state.rest_tension,
        contacts=contacts,
        stabilisation_work=0.0,
        stabilisation_residual=0.0,
        progress={},
    )


def make_model(comm: MPI.Comm, scene: Scene, state: State) -> RopeModel:
    """The rope in the model that a state belongs to, with the state's contact history."""
    rope = one_pitch(scene) if state.model in CELL or one_for_all(scene) else build_rope(scene)
    beams = formed_with_beams(scene) if state.forms else state.model == "beam"
    block = 9 if beams else 3
    reference = np.split(state.reference.reshape(-1, block), rope.num_yarns)
    body: Any
    if state.forms:
        # Material coordinates are those of the start, wherever nodes were spread to.
        if beams:
            start = with_directors(scene, np.concatenate(rope.centre_lines).ravel())
            lines = np.split(start.reshape(-1, 9), rope.num_yarns)
            body = beam_body(comm, scene, lines, 0.0)
        else:
            body = cable_body(comm, scene, rope.centre_lines, 1.0, 0.0)
    elif state.model == "cable":
        body = cable_body(comm, scene, reference, scene.yarn.axial_stiffness, state.rest_tension)
    else:
        body = beam_body(comm, scene, reference, state.rest_tension)
    model = RopeModel(comm, scene, rope, body, _ends(scene, rope, body, state))
    if state.forms:
        model.set_reference(state.reference)
    else:
        density = state.rest_tension**2 / (2.0 * scene.yarn.axial_stiffness)
        model.preload_energy = float(density @ body.rest_lengths())
    model.contact.start = model.proximal.start = state.q
    restore_contacts(model.contact, state)
    return model


def _ends(scene: Scene, rope: Rope, body: Any, state: State) -> Ends | GroupedEnds:
    """What is held: the ends of one pitch are alike; then those of the whole rope as the scene says.

    Groups of ends act once the rope is formed; until then the ends are alike. They need not be symmetric, and the
    rope then is not kept so.
    """
    if scene.ends.groups and not state.forms:
        nodes = EndNodes(body.block, body.layout.curves, state.reference)
        return GroupedEnds(nodes, scene.ends, rope)
    symmetry = symmetry_of(scene, rope)
    pulled = state.forms and keeps_lengths(scene, state)
    alike = replace(scene.ends, transverse="periodic", groups=())
    if state.model in CELL:
        # While nodes are spread along yarns, planes tell where the material is.
        return Ends(body, alike, symmetry, state.q, pulled=pulled, planar=state.model == "cell")
    ends = alike if scene.ends.groups else scene.ends
    at = state.q if state.forms else state.reference
    cut = bool(scene.ends.groups)
    return Ends(body, ends, symmetry, at, pulled=pulled, cut=cut, gauged=not state.forms)
