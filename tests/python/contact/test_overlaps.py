"""Solids that overlap at rest touch there, without force; what comes closer is pressed apart."""

import braidx_engine as engine
import numpy as np
from mpi4py import MPI

from braidx.contact.contact import Contact
from braidx.contact.overlaps import adopt_overlaps
from braidx.contact.skins import SkinLayout
from braidx.contact.tubes import TubeLayout

OVERLAP = 0.03


def sheets():
    """Two square facets, the upper one turned down, that overlap; positions, shape (8, 3), mm."""
    lower = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], dtype=float)
    upper = lower[[0, 2, 1, 3]] + [0.0, 0.0, -OVERLAP]
    return np.concatenate([lower, upper])


def contact_of(points):
    none = np.empty(0, dtype=np.int64)
    tubes = TubeLayout(none, none, none, none, np.empty(0), np.empty(0), none)
    facets = tuple(3 * np.arange(4 * i, 4 * i + 4)[None] for i in range(2))
    skins = SkinLayout(facets, np.array([0, 1]), np.array([-1, -1]), np.ones(2))
    contact = Contact(
        MPI.COMM_SELF, tubes, smooth=False, symmetric=False, skins=skins, rest=points.ravel()
    )
    contact.pairing.num_bodies = contact.laws.num_bodies = 2
    contact.pairing.search.margin = 0.2
    return contact


def pressure(contact, points):
    contact.elements = engine.ContactElements()
    contact.start = points.ravel()
    contact.update(points.ravel())
    return contact.results(points.ravel())["normal_force"].sum()


def test_an_overlap_at_rest_bears_no_force_and_more_of_it_does():
    points = sheets()
    contact = contact_of(points)
    assert pressure(contact, points) > 1.0
    adopt_overlaps(contact, points.ravel())
    assert pressure(contact, points) < 1e-12
    points[4:, 2] -= 0.01
    assert pressure(contact, points) > 0.1
