"""Solids that are in each other at rest: meshes of round sections that touch have edges and corners in each other."""

from __future__ import annotations

import braidx_engine as engine
import numpy as np

from ..system.terms import Floats
from .contact import Contact


def adopt_overlaps(contact: Contact, q: Floats) -> None:
    """Particles that are in the skins of other solids at the unknowns q count as touching there, without force."""
    nothing = np.empty(0)
    engine.set_rest_overlaps(
        contact.pairing, nothing.astype(np.int32), nothing.astype(np.int64), nothing
    )
    contact.update(q)
    contact.start = q
    results = contact.results(q)
    inside = (results["facet"][:, 1] >= 0) & (results["gap"] < 0.0)
    mine = results["tubes"][inside, 0], results["station"][inside], -results["gap"][inside]
    parts = contact.comm.allgather(mine)
    surface, station, depth = (np.concatenate(column) for column in zip(*parts, strict=True))
    engine.set_rest_overlaps(
        contact.pairing, surface.astype(np.int32), station.astype(np.int64), depth.astype(float)
    )
    contact.restore(engine.ContactElements())
