"""Small bodies of solids of every kind of cell, and linear analysis of them."""

from dataclasses import replace
from functools import cache
from itertools import permutations

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl
from mpi4py import MPI

from braidx.bodies import SolidBody, YarnMaterial
from braidx.meshing import SolidMesh, join, rectangle, sweep
from braidx.meshing.reference import TETRAHEDRA

YARN = YarnMaterial(80.0, 9.0, 4.0, 0.4, 0.3)
SOFT = YarnMaterial.isotropic(50.0, 0.3)
ISOTROPIC = ("Saint-Venant-Kirchhoff", "neo-Hooke")
DIRECTORS = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


def bar(section, length, num_elements):
    """Straight bar along z, directors along x and y."""
    z = np.linspace(0.0, length, num_elements * section.degree + 1)
    line = np.stack([0.0 * z, 0.0 * z, z], axis=1)
    return sweep(line, section, np.broadcast_to(DIRECTORS, (len(z), 2, 3)))


def arc(degree, counts=(2, 1)):
    """Bent bar of two elements along it."""
    angle = np.linspace(0.0, 0.5, 2 * degree + 1)
    line = 3.0 * np.stack([np.cos(angle), 0.2 * angle, np.sin(angle)], axis=1)
    return sweep(line, rectangle(1.0, 0.8, counts, degree))


def tetrahedra(degree):
    """A skew brick of six tetrahedra."""
    corners = np.array([[i & 1, (i >> 1) & 1, i >> 2] for i in range(8)])
    skew = np.array([[1.0, 0.1, 0.0], [0.2, 1.2, 0.1], [0.0, 0.3, 0.9]])
    rows = []
    for order in permutations(range(3)):
        path = np.cumsum([[0, 0, 0]] + [np.eye(3, dtype=int)[i] for i in order], axis=0)
        a, b, c, d = path @ [1, 2, 4]
        odd = np.linalg.det(np.diff(path, axis=0)) < 0.0
        rows.append([a, c, b, d] if odd else [a, b, c, d])
    nodes = corners[np.array(rows)] @ skew
    shape = TETRAHEDRA[1].shape(TETRAHEDRA[degree].points)
    every = np.einsum("nv,cvi->cni", shape, nodes).reshape(-1, 3)
    points, cells = np.unique(np.round(every, 12), axis=0, return_inverse=True)
    fibre = np.tile([0.6, 0.0, 0.8], (6, 1))
    cells = cells.reshape(6, -1)
    return SolidMesh(points, cells, np.zeros(6, dtype=np.int64), fibre, {})


def make_body(kind, degree, law="transversely isotropic", comm=MPI.COMM_SELF):
    """A body of "swept" or "free" hexahedra or of "tetrahedra"; swept ones with two parts and prestress."""
    isotropic = law in ISOTROPIC
    if kind == "swept":
        mesh = join([arc(degree), arc(degree, (1, 1))])
        material = SOFT if isotropic else [YARN, SOFT]
        stress = 0.0 if isotropic else [1.5, 0.0]
        return SolidBody(comm, mesh, material=material, law=law, fibre_stress=stress)
    mesh = tetrahedra(degree) if kind == "tetrahedra" else replace(arc(degree), sweeps={})
    return SolidBody(comm, mesh, material=SOFT if isotropic else YARN, law=law)


cached_body = cache(make_body)

CASES = [
    ("swept", degree, law) for degree in (1, 2) for law in ("transversely isotropic", *ISOTROPIC)
]
CASES += [("free", 1, "transversely isotropic"), ("free", 1, "neo-Hooke")]
CASES += [("tetrahedra", degree, "transversely isotropic") for degree in (1, 2)]


def random_state(body, size=0.05, seed=0):
    """The state at rest plus noise, shape (num_nodes, 3)."""
    return body.rest + size * np.random.default_rng(seed).standard_normal(body.rest.shape)


def stiffness_at_rest(body):
    """Tangent in the reference configuration, sparse."""
    body.set_state(body.rest)
    n = body.num_unknowns
    return sp.csc_matrix((body.tangent_values(), body.tangent_pattern()), shape=(n, n))


def displacements(body, loads, held):
    """Linear response to nodal loads, shape (num_nodes, 3), with some unknowns held."""
    free = np.setdiff1d(np.arange(body.num_unknowns), held)
    result = np.zeros(body.num_unknowns)
    tangent = stiffness_at_rest(body)[free][:, free]
    result[free] = spl.spsolve(tangent.tocsc(), loads.ravel()[free])
    return result.reshape(-1, 3)
