"""The straight rope that is about to be bent: formed yarns laid end to end, free of stress."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from mpi4py import MPI

from ...geometry import build_rope
from ...scene import Scene
from ...system.constraints import Floats
from ..directors import formed_with_beams
from ..state import State, restore_contacts
from .model import BentRope
from .stretches import Stretch, as_table, from_table, stretches_of

BENT = "bent"  # the state's model
WORK_BEFORE = "friction_work_before_bending"  # mJ; where the rope is bent again, friction counts from here again


def straight_lines(scene: Scene, state: State) -> tuple[Floats, ...]:
    """Centre lines of all yarns of the whole sample, shape (num_nodes, 3) each, mm.

    Args:
        scene: The scene.
        state: Of a rope as placed or formed: one pitch, or all of it.
    """
    num_yarns = build_rope(scene).num_yarns
    beams = formed_with_beams(scene) if state.forms else state.model == "beam"
    block = 9 if beams else 3
    lines = state.q.reshape(num_yarns, -1, block)[:, :, :3]
    pitch = scene.rope.pitch
    pitches = round(scene.length / float(np.ptp(lines[0, [0, -1], 2])))
    shifts = pitch * np.arange(pitches)[:, None, None, None] * np.array([0.0, 0.0, 1.0])
    parts = [lines[:, :-1] + shift for shift in shifts]
    whole = np.concatenate([*parts, lines[:, -1:] + shifts[-1]], axis=1)
    return tuple(whole)


def clamped(scene: Scene, state: State) -> State:
    """The state of a rope about to be bent, made from the one that it was formed in; unknowns follow with the model."""
    lines = straight_lines(scene, state)
    state = replace(
        state,
        model=BENT,
        reference=np.concatenate(lines).ravel(),
        rest_tension=np.empty(0),
    )
    state.results[WORK_BEFORE] = state.friction_work
    return with_stretches(state, stretches_of(scene, lines))


def with_stretches(state: State, stretches: Sequence[Stretch]) -> State:
    """A bent rope straight and clamped again, its yarns modelled otherwise."""
    return replace(
        state,
        q=np.empty(0),
        previous=np.empty(0),
        stretches=as_table(stretches),
        contacts={},
        stabilisation_work=0.0,
        stabilisation_residual=0.0,
        friction_work=state.results[WORK_BEFORE],
        progress={},
    )


def make_bent_rope(comm: MPI.Comm, scene: Scene, state: State) -> tuple[BentRope, State]:
    """The model that a state belongs to, with the state's contact history, and the state with its unknowns."""
    num_yarns = int(state.stretches[:, 0].max()) + 1
    lines = tuple(state.reference.reshape(num_yarns, -1, 3))
    model = BentRope(comm, scene, lines, from_table(state.stretches))
    if not len(state.q):
        state = replace(state, q=model.start)
    model.contact.start = model.proximal.start = state.q
    restore_contacts(model.contact, state)
    return model, state
