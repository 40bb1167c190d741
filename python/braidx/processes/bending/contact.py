"""Contact of a bent rope: yarns with each other, with the core and with the sheave."""

from __future__ import annotations

import braidx_engine as engine
import numpy as np
from mpi4py import MPI

from ...contact.contact import Contact
from ...contact.overlaps import adopt_overlaps
from ...scene import Scene
from ...system.constraints import Floats
from ..rope_contact import set_options
from ..threads import num_threads
from .contact_bodies import CORE, SHEAVE, YARN
from .surfaces import NO_YARN, Surfaces

# First penalty over the transverse modulus: touching yarns give way more than their surfaces do.
FIRST_PENALTY = 5.0
MOST_THINNER = 0.03  # of the radius of tubes, for what yarns overlap in the straight rope


def make_contact(comm: MPI.Comm, scene: Scene, surfaces: Surfaces, start: Floats) -> Contact:
    """Contact of all surfaces, with laws and spacing from the scene.

    Args:
        comm, scene: As of the run.
        surfaces: What may touch.
        start: All unknowns of the straight rope.
    """
    contact = Contact(
        comm,
        surfaces.tubes,
        smooth=True,
        symmetric=scene.solver.tangent == "symmetric",
        num_threads=num_threads(comm),
        skins=surfaces.skins,
        rest=start,
    )
    set_options(contact, scene)
    penalty = scene.contact.penalty or FIRST_PENALTY * scene.yarn.transverse_modulus
    contact.pairing.stiffness = penalty
    contact.pairing.area_stiffness = penalty / scene.yarn.radius
    contact.laws.num_bodies = contact.pairing.num_bodies = 3
    contact.laws.friction = friction_table(scene).ravel().tolist()
    may_touch = np.ones((3, 3), dtype=np.int32)
    # Yarns lie between them wherever they come close.
    may_touch[CORE, SHEAVE] = may_touch[SHEAVE, CORE] = 0
    contact.pairing.may_touch = may_touch.ravel().tolist()
    _fit_tubes(contact, start, surfaces)
    if surfaces.skins is not None:
        adopt_overlaps(contact, start)
    return contact


def _fit_tubes(contact: Contact, start: Floats, surfaces: Surfaces) -> None:
    """Makes tubes of yarns thinner by what they overlap in the straight rope, which is free of stress.

    Yarns that were formed under tension are in each other by a percent of their radius.
    """
    contact.update(start)
    contact.start = start
    results = contact.results(start)
    a, b = results["tubes"].T
    num_tubes = len(contact.layout.radius)
    tubes = (a < num_tubes) & (b >= 0) & (b < num_tubes)
    both = (surfaces.yarn[a[tubes]] != NO_YARN) & (surfaces.yarn[b[tubes]] != NO_YARN)
    depth = -results["gap"][tubes] / np.where(both, 2.0, 1.0)
    # Of what was not formed but placed, and lies in each other deeply, contact has to make something.
    deepest = min(float(depth.max(initial=0.0)), MOST_THINNER * float(contact.min_radius))
    thinner = contact.comm.allreduce(deepest, op=MPI.MAX)
    by = np.where(contact.layout.body == YARN, thinner, 0.0)
    contact.set_radius(contact.layout.radius - by)
    contact.restore(engine.ContactElements())


def friction_table(scene: Scene) -> Floats:
    """Coefficient of friction of each pair of bodies, shape (3, 3)."""
    table = np.zeros((3, 3))
    for name, other in (("yarn-yarn", YARN), ("yarn-core", CORE), ("yarn-sheave", SHEAVE)):
        table[YARN, other] = table[other, YARN] = scene.contact.friction_of(name)
    return table
