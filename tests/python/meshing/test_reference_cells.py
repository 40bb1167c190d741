"""Reference cells against basix, whose order of nodes they promise."""

import basix
import numpy as np
import pytest

from braidx.meshing.reference import HEXAHEDRA, QUADS, TETRAHEDRA

CELLS = [(kind[degree], degree) for kind in (QUADS, HEXAHEDRA, TETRAHEDRA) for degree in (1, 2)]


def lagrange(cell, degree):
    return basix.create_element(
        basix.ElementFamily.P,
        basix.CellType[cell.name],
        degree,
        basix.LagrangeVariant.gll_warped,
    )


@pytest.mark.parametrize("cell, degree", CELLS)
def test_nodes_are_in_the_order_of_basix(cell, degree):
    assert cell.points == pytest.approx(lagrange(cell, degree).points, abs=1e-14)


@pytest.mark.parametrize("cell, degree", CELLS)
def test_shape_functions_and_gradients(cell, degree):
    at = 0.3 * np.random.default_rng(0).random((7, cell.points.shape[1]))
    table = lagrange(cell, degree).tabulate(1, at)[..., 0]
    assert cell.shape(at) == pytest.approx(table[0], abs=1e-12)
    assert cell.gradient(at) == pytest.approx(table[1:].transpose(1, 0, 2), abs=1e-12)


@pytest.mark.parametrize("cell", [c for c, _ in CELLS if c.name != "quadrilateral"])
def test_local_facets_are_those_of_basix_turned_outward(cell):
    corners = 3 if cell.is_simplex else 4
    topology = basix.topology(basix.CellType[cell.name])[2]
    assert [sorted(f[:corners]) for f in cell.facets.tolist()] == topology
    for facet in cell.points[cell.facets]:
        a, b, c = facet[:3]
        assert np.dot(np.cross(b - a, c - a), a - cell.points.mean(axis=0)) > 0.0
