"""Loads that turn with rods: their tangents are derivatives of their forces; pressure is that on a closed curve."""

import numpy as np
import pytest
from scipy.sparse import coo_matrix

from braidx.rods.followers import FollowerForceTerm, PressureTerm

SIZE = 30


def follower(rank=0):
    term = FollowerForceTerm(np.array([np.arange(9), np.arange(12, 21), np.arange(21, 30)]), rank)
    term.forces = np.array([[0.3, -2.0, 1.1], [0.7, 0.2, -0.4], [0.0, 0.0, 0.0]])
    return term


def pressure(rank=0):
    lines = [np.arange(15).reshape(5, 3), np.arange(15, 30).reshape(5, 3)]
    term = PressureTerm(lines, [1, 2], rank)
    term.pressures = np.array([[0.1, 0.5, -0.3], [1.0, 0.0, 0.2]])
    return term


def forces(term, q):
    out = np.zeros(SIZE)
    term.set_state(q)
    term.add_residual(out)
    return -out


@pytest.mark.parametrize("make", [follower, pressure])
def test_tangent_is_the_derivative(make):
    rng = np.random.default_rng(2)
    term, q, way, h = make(), rng.standard_normal(SIZE), rng.standard_normal(SIZE), 1e-6
    change = -(forces(term, q + h * way) - forces(term, q - h * way)) / (2 * h)
    term.set_state(q)
    tangent = coo_matrix((term.tangent_values(), term.tangent_pattern()), shape=(SIZE, SIZE))
    assert tangent @ way == pytest.approx(change, rel=1e-7, abs=1e-9)
    assert np.isnan(term.energy(np.ones(SIZE)))


@pytest.mark.parametrize("make", [follower, pressure])
def test_other_processes_give_nothing(make):
    silent = make(rank=1)
    assert not forces(silent, np.ones(SIZE)).any() and silent.tangent_values().size == 0


def test_followers_have_the_force_and_the_way_asked_for():
    q = np.random.default_rng(4).standard_normal(SIZE)
    q[3:9] = [
        0,
        2,
        0,
        0,
        0,
        2,
    ]  # directors along y and z, twice as long: the normal is x, four times as long
    force = forces(follower(), q)
    a = np.array([0.3, -2.0, 1.1])
    way = np.array([4 * a[2], 2 * a[0], 2 * a[1]])
    assert force[:3] == pytest.approx(np.linalg.norm(a) * way / np.linalg.norm(way), rel=1e-12)
    assert not force[3:12].any() and not force[21:].any()


def test_pressure_sums_to_that_on_the_chord():
    """The integral of p e x dx depends on the ends only; its moment is p times twice the area swept."""
    q = np.random.default_rng(4).standard_normal(SIZE)
    term = pressure()
    found = forces(term, q)
    for rod, part in enumerate((slice(0, 15), slice(15, 30))):
        x, f = q[part].reshape(5, 3), found[part].reshape(5, 3)
        assert f.sum(axis=0) == pytest.approx(
            np.cross(term.pressures[rod], x[-1] - x[0]), rel=1e-12
        )
