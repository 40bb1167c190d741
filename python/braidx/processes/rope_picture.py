"""A straight rope as a picture: all of it, with stresses and contacts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from mpi4py import MPI

from ..contact.contact import Contact
from ..output.contact_table import YARN_CORE, YARN_YARN, ContactTable
from ..output.core_line import CoreLine
from ..output.snapshot import Snapshot, repeated
from .state import State

if TYPE_CHECKING:
    from .model import RopeModel


def rope_picture(model: RopeModel, state: State, name: str) -> Snapshot:
    """A state with its contacts, and stresses unless it is being formed; gathered from all processes."""
    q, own_model = state.q, not state.forms
    degree, curves = model.body.layout.degree, model.body.layout.curve_elements
    per_segment = np.repeat(model.tension(q), degree)
    tension = tuple(np.split(per_segment, curves[1:-1] * degree))
    area = float(model.scene.yarn.section_area)
    directors = None
    if model.body.block == 9:
        all_directors = q.reshape(-1, 9)[:, 3:].reshape(-1, 2, 3)
        directors = tuple(np.split(all_directors, model.body.curves[1:-1]))
    picture = Snapshot(
        name,
        model.centre_lines(q),
        model.rope.radius,
        model.rope.strand,
        directors=directors,
        tension=tension,
        axial_stress=(
            tuple(np.divide(t, area, dtype=np.float64) for t in tension) if own_model else None
        ),
        contacts=_contact_table(model, q),
        core=_core(model, q),
    )
    return repeated(picture, model.copies)


def _core(model: RopeModel, q: np.ndarray) -> CoreLine | None:
    """The core, which stays straight and round while the rope is straight."""
    core = model.scene.core
    if core is None:
        return None
    lines = model.centre_lines(q)
    low, high = (float(np.mean([line[end, 2] for line in lines])) for end in (0, -1))
    height = np.linspace(low, high, len(lines[0]))
    line = np.stack([np.zeros_like(height), np.zeros_like(height), height], axis=1)
    return CoreLine(line, core.radius, core.inner_radius)


def _contact_table(model: RopeModel, q: np.ndarray) -> ContactTable:
    whole = gathered_results(model.comm, model.contact, q)
    other = whole["tubes"][:, 1]
    # A die, which comes after the core, is no part of the rope.
    kept = {
        name: values[other >= (-1 if model.scene.core else 0)] for name, values in whole.items()
    }
    a, b = kept["tubes"].astype(np.int64).T
    kind = np.where(b < 0, YARN_CORE, YARN_YARN)
    return ContactTable(**contact_columns(kept), yarn_a=a, yarn_b=b, kind=kind)


def gathered_results(comm: MPI.Comm, contact: Contact, q: np.ndarray) -> dict[str, np.ndarray]:
    """Results per contact element of all processes (Contact.results), the same on each."""
    parts = comm.allgather(contact.results(q))
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def contact_columns(results: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Columns of a table of contacts that do not depend on what touches what."""
    same = ("position", "normal", "gap", "normal_force", "work")
    return {
        **{name: results[name] for name in same},
        "friction_force": -results["friction_force"],
        "reversible_slip": np.linalg.norm(results["slip"], axis=1),
    }
