"""Overlaps that an equilibrium does not know of, since its contact elements stand beside them."""

from __future__ import annotations

import braidx_engine as engine
import numpy as np

from ..contact.contact import Contact
from ..system.terms import Floats

HIDDEN = (
    0.01  # sums of radii: overlap, beyond that of the contact elements, that counts as not known
)


def hidden_overlap(contact: Contact, q: Floats) -> tuple[float, int, int]:
    """Deepest overlap of two rods that is not known, mm, and the rods; of all processes. 0 where there is none.

    While an equilibrium is being found, places where rods cross are followed but not looked for: one that jumps is
    lost, and what stands beside it sees less. Contact elements made anew, as if nothing had touched before, see it.

    Args:
        contact: With the contact elements of the equilibrium.
        q: The equilibrium, shape (num_unknowns,).
    """
    known = _depths(contact, q, contact.elements)
    radius, worst = contact.layout.radius, (0.0, 0, 0)
    for (a, b), depth in overlaps(contact, q).items():
        more = depth - known.get((a, b), 0.0)
        if more > HIDDEN * (radius[a] + radius[b]):
            worst = max(worst, (more, a, b))
    return max(contact.comm.allgather(worst))


def overlaps(contact: Contact, q: Floats) -> dict[tuple[int, int], float]:
    """Deepest overlap of each two tubes that overlap in the state q, mm, as contact elements made anew see it."""
    contact.pairing.within_increment = False
    fresh = engine.make_contact_elements(
        contact.surfaces,
        contact.crossings,
        contact.rigid,
        q,
        q,
        engine.ContactElements(),
        contact.pairing,
    )
    return _depths(contact, q, fresh)


def _depths(
    contact: Contact, q: Floats, elements: engine.ContactElements
) -> dict[tuple[int, int], float]:
    """Deepest overlap of each two rods by contact elements, mm."""
    gaps = engine.contact_results(
        contact.surfaces, elements, q, q, contact.laws, contact.num_threads
    )["gap"]
    tubes, num_tubes = elements.arrays()["tubes"], len(contact.layout.radius)
    depths: dict[tuple[int, int], float] = {}
    of_tubes = np.all((tubes >= 0) & (tubes < num_tubes), axis=1)
    for i in np.flatnonzero((gaps < 0.0) & of_tubes):
        a, b = int(tubes[i, 0]), int(tubes[i, 1])
        depths[a, b] = max(depths.get((a, b), 0.0), -float(gaps[i]))
    return depths
