"""Small bodies of curved yarns in a state away from rest."""

from functools import cache

import numpy as np
from mpi4py import MPI

from braidx.bodies import BeamBody, BeamSection, CableBody, CurveBody, YarnMaterial

SECTIONS = (BeamSection.round(0.8), BeamSection(2.0, 0.3, 0.5, 0.6, 1.7))
MATERIALS = (YarnMaterial(80.0, 9.0, 4.0, 0.4, 0.3), YarnMaterial.isotropic(50.0, 0.2))


def helix(num_nodes: int, phase: float, length: float = 12.0) -> np.ndarray:
    """Nodes on a helix of radius 3 mm and one turn along z, shape (num_nodes, 3), mm."""
    z = np.linspace(0.0, length, num_nodes)
    angle = phase + 2.0 * np.pi * z / length
    return np.stack([3.0 * np.cos(angle), 3.0 * np.sin(angle), z], axis=1)


def centre_lines() -> list[np.ndarray]:
    """Two curves with different numbers of nodes, odd ones, so that they serve degree 2 as well."""
    return [helix(5, 0.0), helix(7, 2.0)]


def make_body(model: str, degree: int, comm: MPI.Comm = MPI.COMM_SELF) -> CurveBody:
    """A body of the two curves with different properties in each."""
    if model == "cable":
        return CableBody(
            comm,
            centre_lines(),
            axial_stiffness=[100.0, 150.0],
            tension=[5.0, 7.0],
            degree=degree,
            area=2.0,
        )
    return BeamBody(
        comm,
        centre_lines(),
        section=SECTIONS,
        material=MATERIALS,
        degree=degree,
        bundle_factor=0.3 if model == "beam of one factor" else [0.05, 0.6],
        torsion_factor=0.3,
        natural_state="straight" if model == "straight beam" else "as placed",
        tension=[2.0, 3.0] if model in ("tense beam", "linear beam") else 0.0,
        axial_law="linear" if model == "linear beam" else "Saint-Venant-Kirchhoff",
    )


cached_body = cache(make_body)


def random_state(body: CurveBody, size: float = 0.1, seed: int = 0) -> np.ndarray:
    """The state at rest plus noise, shape (num_nodes, block)."""
    return body.rest + size * np.random.default_rng(seed).standard_normal(body.rest.shape)


def dense_tangent(body: CurveBody) -> np.ndarray:
    """Tangent of the current state, shape (num_unknowns, num_unknowns)."""
    rows, columns = body.tangent_pattern()
    matrix = np.zeros((body.num_unknowns, body.num_unknowns))
    np.add.at(matrix, (rows, columns), body.tangent_values())
    return matrix
