"""How rods touch, unless told otherwise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from mpi4py import MPI

from ..contact.contact import Contact
from .layout import Layout

REGULARISATION = 1e-4  # of the radius: gap over which the normal force sets in
REVERSIBLE_SLIP = 1e-3  # of the radius
SPACING = 2.0  # radii between stations at most: those of long elements would miss how near rods come between them
MISSED = 5e-3  # of the radius: what stations along a line may miss of a crossing before it gets one of its own


def make_contact(
    comm: MPI.Comm,
    layout: Layout,
    each_other: bool,
    self_contact: float | None,
    spacing: float | None,
) -> Contact:
    """Contact of rods; see Rods for the arguments. Its tangent is the consistent one."""
    tubes, skins = layout.tubes, layout.skins
    if not each_other:
        tubes = replace(tubes, group=0 * tubes.num_elements)
        skins = None if skins is None else replace(skins, group=0 * skins.group)
    contact = Contact(comm, tubes, smooth=True, symmetric=False, skins=skins, rest=layout.rest)
    half = float(tubes.element_length.min(initial=np.inf)) / 2.0
    contact.pairing.spacing = spacing or min(half, SPACING * contact.min_radius)
    contact.pairing.search.margin = contact.min_radius / 2.0
    contact.pairing.search.self_exclusion = np.inf if self_contact is None else self_contact
    contact.pairing.point_tolerance = MISSED * contact.min_radius
    contact.laws.regularisation = REGULARISATION * contact.min_radius
    contact.laws.reversible_slip = REVERSIBLE_SLIP * contact.min_radius
    return contact
