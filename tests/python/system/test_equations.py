"""Equations between unknowns as constraints, against dense algebra."""

import numpy as np
import pytest

from braidx.system.constraints import Constraints
from braidx.system.equations import Dependent, follow_best, impose

N = 10
UNKNOWNS = np.array([1, 2, 3, 5, 6, 7, 8])


def tied():
    constraints, values = Constraints(N), np.zeros(N)
    constraints.hold([1])
    constraints.tie([2], [3])
    values[[1, 2]] = 0.7, -0.4
    return constraints, values


def equations(seed=0, count=3):
    rng = np.random.default_rng(seed)
    rows = rng.standard_normal((count, len(UNKNOWNS)))
    rows[0, 3:] = 0.0
    return rows, rng.standard_normal(count)


def test_all_states_that_meet_the_constraints_are_reached_and_no_others():
    constraints, values = tied()
    rows, wanted = equations()
    impose(constraints, values, UNKNOWNS, rows, wanted)
    resolved = constraints.resolve()
    dense = np.zeros((5, N))
    dense[0, 1] = dense[1, 2] = 1.0
    dense[1, 3] = -1.0
    dense[2:, UNKNOWNS] = rows
    right = np.array([0.7, -0.4, *wanted])
    free_values = np.random.default_rng(2).standard_normal(len(resolved.free))
    np.testing.assert_allclose(dense @ resolved.expand(free_values, values), right, atol=1e-13)
    transform = resolved.transform.toarray()
    assert np.linalg.matrix_rank(transform) == N - 5 == len(resolved.free)
    np.testing.assert_allclose(dense @ transform, 0.0, atol=1e-13)


def test_the_equation_that_says_nothing_new_is_named():
    constraints, values = tied()
    rows, wanted = equations()
    rows[2] = 2.0 * rows[1] - rows[0]
    rows[2, 0] += 5.0  # of an unknown that is held
    with pytest.raises(Dependent) as caught:
        impose(constraints, values, UNKNOWNS, rows, wanted)
    assert caught.value.row == 2


def test_equations_that_share_no_unknowns_do_not_couple():
    constraints, values = Constraints(N), np.zeros(N)
    rows = np.zeros((2, len(UNKNOWNS)))
    rows[0, :3], rows[1, 3:] = 1.0, 1.0
    impose(constraints, values, UNKNOWNS, rows, np.zeros(2))
    assert constraints.resolve().transform.nnz == (N - 2) + 2 + 3


def test_motions_follow_a_few_of_their_entries():
    rng = np.random.default_rng(3)
    columns = rng.standard_normal((8, 2)) @ np.array([[1.0, 0.0, 2.0], [0.0, 1e3, 1.0]])
    leading, follow = follow_best(columns)
    assert len(leading) == 2
    np.testing.assert_allclose(follow[leading], np.eye(2), atol=1e-12)
    np.testing.assert_allclose(follow @ columns[leading], columns, atol=1e-9)
    assert np.abs(follow).max() < 10.0
    for nothing in (np.zeros((8, 0)), np.zeros((8, 2))):
        leading, follow = follow_best(nothing)
        assert not len(leading) and follow.shape == (8, 0)
