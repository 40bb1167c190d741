"""Two sheets on elastic layers pressed together: how even the contact pressure gets.

Points of each sheet act on the other. Between facets that match the pressure is even. Between others, forces of nodes
are integrals over shape functions with kinks between the points, and the pressure of the layers, whose nodes know
nothing of each other, is uneven.
"""

import basix
import numpy as np
import pytest
from sheets import KINDS, contact_of, residual, sheet, tangent

SIZE = (6.0, 4.0)
PRESSURE, LAYER, PENALTY = 10.0, 200.0, 1000.0  # MPa, MPa per mm, N/mm per mm^2


def consistent_matrix(nodes, facets):
    """Integrals of products of shape functions over a sheet, shape (num_nodes, num_nodes), mm^2."""
    kind = facets.shape[1]
    cell = basix.CellType.triangle if kind in (3, 6) else basix.CellType.quadrilateral
    degree = 1 if kind in (3, 4) else 2
    element = basix.create_element(
        basix.ElementFamily.P, cell, degree, lagrange_variant=basix.LagrangeVariant.equispaced
    )
    points, weights = basix.make_quadrature(cell, 2 * degree + 2)
    values, du, dv = element.tabulate(1, points)[:, :, :, 0]
    out = np.zeros((len(nodes), len(nodes)))
    for facet in (facets - facets.min()) // 3:
        area = np.cross(du @ nodes[facet], dv @ nodes[facet])[:, 2]
        out[np.ix_(facet, facet)] += (values.T * weights * abs(area)) @ values
    return out


def pressed(kind_a, kind_b, counts_b, dense=False):
    """Results of contact and pressures of both layers at their nodes, MPa, in equilibrium at PRESSURE on average."""
    a, facets_a = sheet(kind_a, (3, 2), SIZE, up=True)
    b, facets_b = sheet(kind_b, counts_b, SIZE, up=False, first=a.size)
    rest = np.concatenate([a, b])
    contact = contact_of(rest, [facets_a, facets_b], dense=dense)
    contact.pairing.area_stiffness = PENALTY
    layers = np.zeros((len(rest), len(rest)))
    layers[: len(a), : len(a)] = LAYER * consistent_matrix(a, facets_a)
    layers[len(a) :, len(a) :] = LAYER * consistent_matrix(b, facets_b)
    penetration = PRESSURE / PENALTY + 0.5 * contact.laws.regularisation
    of_b = np.arange(len(rest)) >= len(a)
    base = np.where(of_b, -2 * PRESSURE / LAYER - penetration, 0.0)
    z = np.where(of_b, base + PRESSURE / LAYER, -PRESSURE / LAYER)
    for _ in range(12):
        q = rest + np.outer(z, [0, 0, 1])
        contact.update(q.ravel())
        out_of_balance = residual(contact, q)[2::3] + layers @ (z - base)
        z = z - np.linalg.solve(tangent(contact, q)[2::3, 2::3] + layers, out_of_balance)
    assert np.linalg.norm(out_of_balance) < 2e-6 * PRESSURE * SIZE[0] * SIZE[1]
    return contact.results(q.ravel()), LAYER * abs(z - base)


@pytest.mark.parametrize("kind", [4, 9])
def test_pressure_between_matching_facets_is_even(kind):
    results, layer = pressed(kind, kind, (3, 2))
    assert results["normal_force"] / results["weight"] == pytest.approx(PRESSURE, rel=1e-9)
    assert layer == pytest.approx(PRESSURE, rel=1e-9)


@pytest.mark.parametrize("dense, uneven", [(False, 0.15), (True, 0.085)])
@pytest.mark.parametrize("kind_a", KINDS)
@pytest.mark.parametrize("kind_b", KINDS)
def test_pressure_between_facets_that_do_not_match(kind_a, kind_b, dense, uneven):
    """How uneven: the worst node of 16 pairs of kinds; the best has 1 %. On average the pressure is right."""
    results, layer = pressed(kind_a, kind_b, (4, 5), dense)
    assert layer == pytest.approx(PRESSURE, rel=uneven)
    mean = results["normal_force"].sum() / (SIZE[0] * SIZE[1])
    assert mean == pytest.approx(PRESSURE, rel=0.002)
