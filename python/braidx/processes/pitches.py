"""From one pitch in a die to the whole rope at rest, stage by stage.

A pitch is formed with end sections that are alike. Released from its die it comes to rest; then it is laid end to end.
At the joints contact elements lack what lies beyond the end: first the joints come to rest, all else held, and then the
whole rope.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..contact.contact import Contact
from ..scene import Scene
from ..system.constraints import Floats
from .form import ONCE_MORE, in_die, spread_nodes
from .model import RopeModel
from .state import CELL, State

JOINT = 3  # elements to either side of a joint that move while it comes to rest
POINT_STATION = np.iinfo(np.int64).max  # engine: stations.h


def next_stage(model: RopeModel, state: State) -> State | None:
    """What is formed next; None after the whole rope."""
    if state.model == "cell" and in_die(model.scene, state):
        q = spread_nodes(model.centre_lines(state.q))
        return replace(state, model="released", q=q, reference=q.copy())
    if state.model in CELL:
        return laid_end_to_end(model, state)
    if state.model == "joints":
        return replace(state, model="forming", progress={**state.progress, **ONCE_MORE})
    return None


def distance_to_joint(scene: Scene, curves: np.ndarray) -> np.ndarray:
    """Number of nodes between a node and the nearest joint of two pitches, shape (num_nodes,)."""
    per_pitch = scene.yarn.elements_per_pitch * scene.yarn.degree
    node = np.arange(curves[1])
    joints = per_pitch * np.arange(1, scene.rope.pitches)
    nearest = np.abs(node[:, None] - joints).min(axis=1, initial=len(node))
    return np.tile(nearest, len(curves) - 1)


def laid_end_to_end(model: RopeModel, state: State) -> State:
    """The state of all pitches of the scene.

    Args:
        model: One pitch.
        state: Its state, formed.
    """
    scene = model.scene
    pitches = scene.rope.pitches
    tension = state.rest_tension.reshape(-1, scene.yarn.elements_per_pitch)

    def repeated(q: Floats) -> Floats:
        lines = q.reshape(len(tension), -1, 3)
        shifts = np.arange(pitches)[:, None, None] * np.array(
            [0.0, 0.0, np.ptp(lines[0, [0, -1], 2])]
        )
        parts = [lines[:, :-1] + shift for shift in shifts]
        return np.concatenate([*parts, lines[:, -1:] + shifts[-1]], axis=1).ravel()

    q = repeated(state.q)
    return replace(
        state,
        model="joints" if pitches > 1 else "forming",
        q=q,
        reference=repeated(state.reference),
        rest_tension=np.tile(tension, pitches).ravel(),
        contacts=_repeated_contacts(model.contact, state.contacts, pitches),
        progress={**state.progress, **ONCE_MORE},
    )


def _repeated_contacts(
    contact: Contact, arrays: dict[str, np.ndarray], pitches: int
) -> dict[str, np.ndarray]:
    """Contact elements of all pitches, with their memory.

    Stations count cells of the mean rest arc length from the start of the tubes (engine: stations.h): each element
    gets the number of the cell that it stands in now.
    """
    tubes = arrays["tubes"]
    length = contact.layout.element_length[tubes] / contact.pairing.spacing

    def cells(s: np.ndarray, way: int) -> np.ndarray:
        return np.floor((s * length) @ np.array([0.5, 0.5 * way])).astype(np.int64)

    same_way = cells(arrays["s"], 1) == arrays["station"]
    parts = []
    for k in range(pitches):
        s = arrays["s"] + k * contact.layout.num_elements[tubes]
        station = np.where(same_way, cells(s, 1), cells(s, -1))
        at_point = arrays["station"] == POINT_STATION
        parts.append({**arrays, "s": s, "station": np.where(at_point, POINT_STATION, station)})
    return {name: np.concatenate([part[name] for part in parts]) for name in arrays}
