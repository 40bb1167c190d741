"""Linear constraints, against the algebraic oracle T^T A T."""

import numpy as np
import pytest
import scipy.sparse as sp

from braidx.system.constraints import Constraints

N = 12


def tied():
    constraints = Constraints(N)
    constraints.hold([0, 3])
    constraints.tie([1, 2], 5)
    constraints.tie([6], [1])  # follows a follower
    return constraints


def mixed():
    constraints = tied()
    constraints.combine(7, of=[8, 6, 3], factors=[0.5, -2.0, 1.0])
    constraints.hold_mean([9, 10, 11])
    return constraints


@pytest.fixture(params=[tied, mixed])
def constraints(request):
    return request.param().resolve()


def random_matrix(seed=0):
    """Entries of a matrix with repetitions, as terms give them, and the matrix."""
    rng = np.random.default_rng(seed)
    rows, cols = rng.integers(0, N, (2, 80))
    values = rng.standard_normal(80)
    return rows, cols, values, sp.coo_matrix((values, (rows, cols)), shape=(N, N)).toarray()


def test_reduced_pattern_is_the_reduced_matrix(constraints):
    rows, cols, values, matrix = random_matrix()
    reduced = constraints.reduce_pattern(rows, cols)
    kept = (reduced.rows >= 0) & (reduced.cols >= 0)  # held unknowns are dropped by PETSc
    num_free = len(constraints.free)
    found = np.zeros((num_free, num_free))
    np.add.at(found, (reduced.rows[kept], reduced.cols[kept]), reduced.values(values)[kept])
    transform = constraints.transform.toarray()
    np.testing.assert_allclose(found, transform.T @ matrix @ transform, atol=1e-13)


def test_equations_of_images_are_left_out():
    constraints = Constraints(N)
    constraints.hold([0])
    constraints.combine_each([6, 7], [[1, 2], [1, 2]], [[0.6, -0.8], [0.8, 0.6]])
    constraints.repeat([6, 7], [1, 2])
    resolved = constraints.resolve()
    np.testing.assert_array_equal(resolved.copies[:9], [1, 2, 2, 1, 1, 1, 0, 0, 1])
    rows, cols, values, matrix = random_matrix()
    reduced = resolved.reduce_pattern(rows, cols)
    kept = (reduced.rows >= 0) & (reduced.cols >= 0)
    found = np.zeros((len(resolved.free),) * 2)
    np.add.at(found, (reduced.rows[kept], reduced.cols[kept]), reduced.values(values)[kept])
    np.testing.assert_allclose(found, matrix[resolved.free] @ resolved.transform, atol=1e-13)
    residual = np.arange(1.0, N + 1)
    np.testing.assert_allclose(resolved.reduce(residual), residual[resolved.free])


def test_ties_are_a_mere_renumbering():
    rows, cols, values, _ = random_matrix()
    reduced = tied().resolve().reduce_pattern(rows, cols)
    assert len(reduced.rows) == len(rows) and reduced.values(values) is values
    assert len(mixed().resolve().reduce_pattern(rows, cols).rows) != len(rows)


def test_reduced_residual_does_the_same_work(constraints):
    rng = np.random.default_rng(1)
    residual, motion = rng.standard_normal(N), rng.standard_normal(len(constraints.free))
    moved = constraints.expand(motion, np.zeros(N))
    assert residual @ moved == pytest.approx(constraints.reduce(residual) @ motion)


def test_expanded_unknowns_meet_the_constraints():
    rng = np.random.default_rng(2)
    constraints, values = mixed().resolve(), rng.standard_normal(N)
    values[constraints.free] = 0.0
    free_values = rng.standard_normal(len(constraints.free))
    q = constraints.expand(free_values, values)
    assert q[[0, 3]] == pytest.approx(values[[0, 3]])
    assert q[[1, 2]] == pytest.approx(q[5] + values[[1, 2]])
    assert q[6] == pytest.approx(q[1] + values[6])
    assert q[7] == pytest.approx(0.5 * q[8] - 2.0 * q[6] + q[3] + values[7])
    assert q[[9, 10, 11]].sum() == pytest.approx(values[11])
    assert q[constraints.free] == pytest.approx(free_values)


def test_no_constraints():
    constraints = Constraints(N).resolve()
    np.testing.assert_array_equal(constraints.free, np.arange(N))
    np.testing.assert_array_equal(constraints.transform.toarray(), np.eye(N))


def test_an_unknown_constrained_twice_is_named():
    constraints = tied()
    with pytest.raises(ValueError, match="unknown 3 is constrained twice"):
        constraints.tie([2 + 1], 8)


def test_a_circle_is_refused():
    constraints = Constraints(N)
    constraints.tie([0], [1])
    constraints.tie([1], [0])
    with pytest.raises(ValueError, match="circle"):
        constraints.resolve()
