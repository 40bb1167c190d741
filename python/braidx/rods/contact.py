"""How rods touch, unless told otherwise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..contact.contact import Contact
from ..contact.tubes import TubeLayout
from .layout import Layout
from .rigid import FIRST_BODY

REGULARISATION = 1e-4  # of the radius: gap over which the normal force sets in
REVERSIBLE_SLIP = 1e-3  # of the radius
CABLE = 3  # unknowns of a node
SPACING = 2.0  # radii between stations at most: those of long elements would miss how near rods come between them
MISSED = 5e-3  # of the radius: what stations along a line may miss of a crossing before it gets one of its own


def make_contact(
    comm: MPI.Comm,
    layout: Layout,
    each_other: bool,
    self_contact: float | None,
    spacing: float | None,
) -> Contact:
    """Contact of rods; see Rods for the arguments. Its tangent is the consistent one.

    Raises:
        ValueError: If a rod that may touch itself begins where it ends.
    """
    if self_contact is not None:
        _refuse_open_rings(layout)
    rods, num_tubes = layout.surface_rods, len(layout.tubes.radius)
    bodies = FIRST_BODY + rods
    tubes, skins = replace(layout.tubes, round_ends=True, body=bodies[:num_tubes]), layout.skins
    if skins is not None:
        skins = replace(skins, body=bodies[num_tubes:])
    if not each_other:
        tubes = replace(tubes, group=0 * tubes.num_elements)
        skins = None if skins is None else replace(skins, group=0 * skins.group)
    contact = Contact(comm, tubes, smooth=True, symmetric=False, skins=skins, rest=layout.rest)
    contact.pairing.spacing = spacing or min(station_spacing(tubes), SPACING * contact.min_radius)
    contact.pairing.search.margin = contact.min_radius / 2.0
    contact.pairing.search.self_exclusion = np.inf if self_contact is None else self_contact
    contact.pairing.point_tolerance = MISSED * contact.min_radius
    contact.laws.regularisation = REGULARISATION * contact.min_radius
    contact.laws.reversible_slip = REVERSIBLE_SLIP * contact.min_radius
    return contact


def keep_apart(contact: Contact, first: int, second: int) -> None:
    """Two rods, or a rod and itself, do not touch from the next contact elements on."""
    size = contact.laws.num_bodies
    table = may_touch(contact).astype(int)
    table[first, second] = table[second, first] = 0
    everything = np.ones((size, size), dtype=int)
    rods = slice(FIRST_BODY, FIRST_BODY + len(table))
    everything[rods, rods] = table
    contact.pairing.num_bodies, contact.pairing.may_touch = size, everything.ravel().tolist()


def may_touch(contact: Contact) -> npt.NDArray[np.bool_]:
    """Whether joints let two rods touch, shape (num_rods, num_rods)."""
    tubes, skins = contact.layout.body, contact.skins
    num_rods = len(tubes) + (0 if skins is None else len(skins.body))
    if not len(contact.pairing.may_touch):
        return np.ones((num_rods, num_rods), dtype=bool)
    table = np.array(contact.pairing.may_touch, dtype=bool).reshape(contact.laws.num_bodies, -1)
    rods = slice(FIRST_BODY, FIRST_BODY + num_rods)
    return np.asarray(table[rods, rods])


def _refuse_open_rings(layout: Layout) -> None:
    """The ends of a rod that begins where it ends are in each other, and would push each other away."""
    for rod, radius in enumerate(layout.radius):
        if rod in layout.joints.rods:
            continue
        ends = layout.rest[layout.unknowns(rod, [0, -1])[:, :3]]
        apart = float(np.linalg.norm(ends[1] - ends[0]))
        if apart < radius:
            raise ValueError(
                f"rod {rod} may touch itself, and its ends are {apart:.3g} mm apart: give closed=True if it is a ring, "
                "or leave two radii between its ends"
            )


def station_spacing(tubes: TubeLayout) -> float:
    """Half of the shortest element, mm; an eighth where it is of degree 2 and a cable's.

    Even stations give too much of a load to the middles of elements of degree 2: half as far apart, a quarter of that.
    Nothing in a cable levels it out.
    """
    curved = (tubes.degree == 2) & (tubes.block == CABLE)
    return float((tubes.element_length / np.where(curved, 8.0, 2.0)).min(initial=np.inf))
