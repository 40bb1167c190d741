"""Couples on directors: their moment, their work on the stretch of sections, their tangent."""

import numpy as np
import pytest

from braidx.rods.couples import CoupleTerm

DIRECTORS = np.array([[3, 4, 5, 6, 7, 8], [12, 13, 14, 15, 16, 17]])
SIZE = 18


@pytest.fixture
def term():
    term = CoupleTerm(DIRECTORS)
    term.couples = np.array([[0.3, -2.0, 1.1], [0.7, 0.2, -0.4]])
    return term


@pytest.fixture
def state():
    """Sections that are stretched and sheared."""
    rng = np.random.default_rng(3)
    q = rng.standard_normal(SIZE)
    q[DIRECTORS] = [1.2, 0.1, 0, -0.2, 0.8, 0.1] + 0.2 * rng.standard_normal((2, 6))
    return q


def forces(term, q):
    """On all unknowns: what the residual lacks."""
    out = np.zeros(SIZE)
    term.set_state(q)
    term.add_residual(out)
    return -out


def test_forces_have_the_moment_of_the_couple(term, state):
    moment = np.cross(
        state[DIRECTORS].reshape(2, 2, 3), forces(term, state)[DIRECTORS].reshape(2, 2, 3)
    )
    assert moment.sum(axis=1) == pytest.approx(term.couples, rel=1e-12)


def test_no_force_on_positions_and_no_work_on_stretch(term, state):
    force = forces(term, state)
    assert not np.delete(force, DIRECTORS.ravel()).any()
    g, f = (v[DIRECTORS].reshape(2, 2, 3) for v in (state, force))
    assert np.einsum("nai,nai->na", g, f) == pytest.approx(np.zeros((2, 2)), abs=1e-14)


def test_work_on_a_small_turn_is_that_of_the_couple(term, state):
    axis = np.array([0.2, 0.5, -0.3])
    change = np.cross(axis, state[DIRECTORS].reshape(2, 2, 3)).reshape(2, 6)
    work = (forces(term, state)[DIRECTORS] * change).sum(axis=1)
    assert work == pytest.approx(term.couples @ axis, rel=1e-12)


def test_tangent_is_the_derivative_of_the_residual(term, state):
    term.set_state(state)
    tangent = np.zeros((SIZE, SIZE))
    np.add.at(tangent, term.tangent_pattern(), term.tangent_values())
    steps = 1e-6 * np.eye(SIZE)
    slopes = [(forces(term, state - s) - forces(term, state + s)) / 2e-6 for s in steps]
    assert tangent == pytest.approx(np.transpose(slopes), abs=1e-8)
    assert np.abs(tangent - tangent.T).max() > 0.1  # not conservative


def test_other_processes_give_nothing(state):
    silent = CoupleTerm(DIRECTORS, rank=1)
    silent.couples = np.ones((2, 3))
    assert not forces(silent, state).any() and silent.tangent_values().size == 0
