"""Derivatives of the functionals of heat against differences, and what their matrices mean."""

from __future__ import annotations

import numpy as np
import pytest
from dolfinx import fem
from mpi4py import MPI

from braidx.bodies.assembly import Assembler
from braidx.forms import heat
from braidx.thermal.cylinder_mesh import CylinderMesh

MESH = CylinderMesh(MPI.COMM_SELF, np.array([1.0, 2.5, 6.0]), np.array([0.0, 3.0, 10.0, 12.0]))
FUNCTIONALS = {
    "capacity": lambda u, c: heat.capacity(u, c, 5),
    "conduction": lambda u, c: heat.conduction(u, 0.5 * c, 2.0 * c, 5),
    "convection": lambda u, c: heat.convection(u, c, 5),
}


@pytest.mark.parametrize("name", FUNCTIONALS)
def test_residual_and_tangent_against_differences(name: str) -> None:
    unknown, constant = fem.Function(MESH.space), fem.Constant(MESH.mesh, 0.7)
    variation = FUNCTIONALS[name](unknown, constant)
    assembler = Assembler([variation], MESH.space, MESH.nodes, MESH.num_nodes)
    generator = np.random.default_rng(2)
    state, direction = generator.normal(size=(2, MESH.num_nodes))

    def at(values: np.ndarray) -> tuple[float, np.ndarray]:
        unknown.x.array[:] = values[MESH.nodes]
        return assembler.energy(), assembler.residual().copy()

    step = 1e-4
    (above, above_residual), (below, below_residual) = at(state + step * direction), at(
        state - step * direction
    )
    energy, residual = at(state)
    rows, columns = assembler.tangent_pattern()
    matrix = np.zeros((MESH.num_nodes, MESH.num_nodes))
    np.add.at(matrix, (rows, columns), assembler.tangent_values())
    assert (above - below) / (2 * step) == pytest.approx(residual @ direction, rel=1e-7)
    slope = (above_residual - below_residual) / (2 * step)
    np.testing.assert_allclose(slope, matrix @ direction, rtol=1e-6, atol=1e-7 * abs(slope).max())
    assert energy == pytest.approx(0.5 * state @ matrix @ state)


def test_sums_of_the_matrices_are_volume_and_surface() -> None:
    unknown, one = fem.Function(MESH.space), fem.Constant(MESH.mesh, 1.0)
    expected = {
        "capacity": np.pi * (36 - 1) * 12.0,
        "conduction": 0.0,
        "convection": 2 * np.pi * 6.0 * 12.0,  # neither the bore nor the ends
    }
    for name, value in expected.items():
        variation = FUNCTIONALS[name](unknown, one)
        assembler = Assembler([variation], MESH.space, MESH.nodes, MESH.num_nodes)
        assert assembler.tangent_values().sum() == pytest.approx(value, abs=1e-9)
