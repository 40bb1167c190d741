"""Contact of a bent rope: yarns with each other, with the core and with the sheave."""

from __future__ import annotations

import numpy as np
from mpi4py import MPI

from ...contact.contact import Contact
from ...scene import Scene
from ..rope_contact import set_options
from ..threads import num_threads
from .assembly import CORE, SHEAVE, YARN, Assembly

FIRST_PENALTY = 0.5  # first penalty per length over the transverse modulus: how yarns give way that touch along a line


def make_contact(comm: MPI.Comm, scene: Scene, assembly: Assembly) -> Contact:
    """Contact of all bodies, with laws and spacing from the scene."""
    contact = Contact(
        comm,
        assembly.tubes(),
        smooth=True,
        symmetric=scene.solver.tangent == "symmetric",
        num_threads=num_threads(comm),
    )
    set_options(contact, scene)
    contact.pairing.stiffness = scene.contact.penalty or FIRST_PENALTY * scene.yarn.transverse_modulus
    contact.laws.num_bodies = 3
    contact.laws.friction = friction_table(scene).ravel().tolist()
    return contact


def friction_table(scene: Scene) -> np.ndarray:
    """Coefficient of friction of each pair of bodies, shape (3, 3)."""
    table = np.zeros((3, 3))
    for name, other in (("yarn-yarn", YARN), ("yarn-core", CORE), ("yarn-sheave", SHEAVE)):
        table[YARN, other] = table[other, YARN] = scene.contact.friction_of(name)
    table[CORE, SHEAVE] = table[SHEAVE, CORE] = scene.contact.friction_of("yarn-sheave")
    return table
