"""Flat sheets of facets as skins, for tests."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse as sp
from mpi4py import MPI

from braidx.contact.contact import Contact
from braidx.contact.skins import SkinLayout
from braidx.contact.tubes import TubeLayout, no_tubes

Array = np.ndarray[Any, Any]

NO_TUBES = no_tubes()

# Places of a facet's nodes in its square, in halves of its sides, in the order of DOLFINx.
SQUARES = {
    4: [(0, 0), (2, 0), (0, 2), (2, 2)],
    9: [(0, 0), (2, 0), (0, 2), (2, 2), (1, 0), (0, 1), (2, 1), (1, 2), (1, 1)],
}
# Two triangles per square.
TRIANGLES = {
    3: [[(0, 0), (2, 0), (0, 2)], [(2, 2), (0, 2), (2, 0)]],
    6: [
        [(0, 0), (2, 0), (0, 2), (1, 1), (0, 1), (1, 0)],
        [(2, 2), (0, 2), (2, 0), (1, 1), (2, 1), (1, 2)],
    ],
}
KINDS = (3, 4, 6, 9)


def sheet(
    kind: int, counts: tuple[int, int], size: tuple[float, float], *, up: bool, first: int = 0
) -> tuple[Array, Array]:
    """A sheet of squares, or pairs of triangles, in the plane z = 0.

    Args:
        kind: Nodes per facet.
        counts, size: Squares and length (mm) along x and y.
        up: Whether its normal is along +z.
        first: Engine number of the first unknown.

    Returns:
        Nodes, shape (num_nodes, 3), mm; facets as engine numbers, shape (num_facets, kind).
    """
    nx, ny = counts
    patterns = TRIANGLES[kind] if kind in TRIANGLES else [SQUARES[kind]]
    number: dict[tuple[int, int], int] = {}
    facets = []
    for j in range(ny):
        for i in range(nx):
            for pattern in patterns:
                places = [(2 * i + u, 2 * j + v) for u, v in pattern]
                facets.append([number.setdefault(p, len(number)) for p in places])
    nodes = np.zeros((len(number), 3))
    nodes[:, :2] = np.array(list(number)) / [2 * nx, 2 * ny] * np.array(size)
    if not up:
        nodes[:, 0] = size[0] - nodes[:, 0]
    return nodes, first + 3 * np.array(facets)


def skins_of(facets: list[Array], radius: float = 0.5, dense: bool = False) -> SkinLayout:
    count = len(facets)
    body = np.arange(count)
    return SkinLayout(tuple(facets), body, np.full(count, -1), np.full(count, radius), dense=dense)


def contact_of(
    rest: Array,
    facets: list[Array],
    tubes: TubeLayout = NO_TUBES,
    friction: float = 0.0,
    dense: bool = False,
    num_bodies: int = 3,
    comm: MPI.Comm = MPI.COMM_SELF,
) -> Contact:
    """Contact of skins, whose bodies are 0, 1..., with the penalty of tests."""
    contact = Contact(
        comm,
        tubes,
        smooth=True,
        symmetric=False,
        skins=skins_of(facets, dense=dense),
        rest=rest.ravel(),
    )
    contact.laws.num_bodies = num_bodies
    contact.laws.friction = [friction] * num_bodies**2
    contact.start = rest.ravel()
    return contact


def residual(contact: Contact, q: Array) -> Array:
    out = np.zeros(q.size)
    contact.set_state(q.ravel())
    contact.add_residual(out)
    return out


def tangent(contact: Contact, q: Array) -> Array:
    contact.set_state(q.ravel())
    entries = contact.tangent_values(), contact.tangent_pattern()
    return np.asarray(sp.csr_matrix(entries, shape=(q.size,) * 2).todense())
