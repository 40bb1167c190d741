"""From one pitch in a die to the whole rope at rest, stage by stage.

A pitch is formed with end sections that are alike, in contact with what goes on beyond them. Released from its die it
comes to rest; there the rope is formed if one pitch stands for all (geometry/symmetry.py). If not, it is laid end to
end and comes to rest with the ends that it has.
"""

from __future__ import annotations

from dataclasses import replace

import braidx_engine as engine
import numpy as np

from ..contact.contact import Contact
from ..geometry import goes_on, one_for_all
from ..system.constraints import Floats
from .directors import with_directors
from .form import ONCE_MORE, in_die, spread_nodes
from .model import RopeModel
from .state import CELL, State

POINT_STATION = np.iinfo(np.int64).max  # engine: stations.h


def next_stage(model: RopeModel, state: State) -> State | None:
    """What is formed next; None at the end."""
    if state.model == "cell" and in_die(model.scene, state):
        q = spread_nodes(model.centre_lines(state.q))
        q = with_directors(model.scene, q) if model.body.block == 9 else q
        return replace(state, model="released", q=q, reference=q.copy())
    if state.model in CELL and not one_for_all(model.scene):
        return laid_end_to_end(model, state)
    return None


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
        lines = q.reshape(len(tension), -1, model.body.block)
        period = np.zeros(model.body.block)
        period[2] = np.ptp(lines[0, [0, -1], 2])
        shifts = np.arange(pitches)[:, None, None] * period
        parts = [lines[:, :-1] + shift for shift in shifts]
        return np.concatenate([*parts, lines[:, -1:] + shifts[-1]], axis=1).ravel()

    q = repeated(state.q)
    return replace(
        state,
        model="forming",
        q=q,
        reference=repeated(state.reference),
        rest_tension=np.tile(tension, pitches).ravel(),
        contacts=_repeated_contacts(model.contact, state.contacts, pitches, goes_on(scene)),
        progress={**state.progress, **ONCE_MORE},
    )


def _repeated_contacts(
    contact: Contact, arrays: dict[str, np.ndarray], pitches: int, periodic: bool
) -> dict[str, np.ndarray]:
    """Contact elements of all pitches, with their memory.

    Stations count cells of the mean rest arc length from the start of the tubes (engine: stations.h): each element
    gets the number of the cell that it stands in now.
    """
    tubes = arrays["tubes"]
    spacing = contact.pairing.spacing
    here = engine.cell_lengths(contact.tubes, *tubes.T.astype(np.int64), spacing)
    there = here if periodic else spacing

    def cells(s: np.ndarray, way: int, cell: np.ndarray | float) -> np.ndarray:
        mean = (s * contact.layout.element_length[tubes]) @ np.array([0.5, 0.5 * way])
        return np.floor(mean / cell).astype(np.int64)

    same_way = cells(arrays["s"], 1, here) == arrays["station"]
    parts = []
    for k in range(pitches):
        s = arrays["s"] + k * contact.layout.num_elements[tubes]
        station = np.where(same_way, cells(s, 1, there), cells(s, -1, there))
        at_point = arrays["station"] == POINT_STATION
        parts.append({**arrays, "s": s, "station": np.where(at_point, POINT_STATION, station)})
    return {name: np.concatenate([part[name] for part in parts]) for name in arrays}
