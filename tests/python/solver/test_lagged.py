"""Systems solved with the factors of an earlier matrix."""

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI
from petsc4py import PETSc

from braidx.solver.lagged import OFTEN, LaggedFactors

SIZE = 120
SPRINGS = sp.diags([2.1, -1.0, -1.0], [0, 1, -1], (SIZE, SIZE))


def petsc(matrix):
    matrix = sp.csr_matrix(matrix)
    return PETSc.Mat().createAIJ(
        matrix.shape, csr=(matrix.indptr, matrix.indices, matrix.data), comm=MPI.COMM_SELF
    )


def solved(factors, matrix):
    """Solution of the context as a preconditioner, as Newton's method uses it; relative residual."""
    ksp = PETSc.KSP().create(MPI.COMM_SELF)
    ksp.setType("preonly")
    ksp.getPC().setType("python")
    ksp.getPC().setPythonContext(factors)
    a = petsc(matrix)
    ksp.setOperators(a)
    right, x = a.createVecs()
    right.array[:] = np.random.default_rng(2).standard_normal(SIZE)
    ksp.solve(right, x)
    residual = np.linalg.norm(matrix @ x.array - right.array) / np.linalg.norm(right.array)
    return residual, ksp.getConvergedReason()


def contacts(count):
    """Stiff contacts between particles far from each other, in a pattern of their own."""
    rng = np.random.default_rng(count)
    matrix = sp.lil_matrix((SIZE, SIZE))
    for _ in range(count):
        i, j = rng.choice(SIZE, 2, replace=False)
        matrix[[i, i, j, j], [i, j, i, j]] = matrix[[i, i, j, j], [i, j, i, j]].toarray() + [
            50.0,
            -50.0,
            -50.0,
            50.0,
        ]
    return SPRINGS + sp.csr_matrix(matrix)


def test_one_factorisation_serves_while_few_contacts_change():
    factors = LaggedFactors("test_")
    for count in (0, 3, 6):
        residual, reason = solved(factors, contacts(count))
        assert residual < 1.1e-3 and reason > 0
    assert factors.factorisations == 1
    assert 3 < factors.solves < 3 * OFTEN


def test_many_changes_bring_new_factors_at_once():
    factors = LaggedFactors("test_")
    solved(factors, SPRINGS)
    residual, _ = solved(factors, contacts(100))
    assert residual < 1e-3 and factors.factorisations == 2


def test_gmres_is_tried_less_often_where_it_fails():
    factors = LaggedFactors("test_")
    solves = []
    for count in (10, 100, 15, 120, 20, 110, 30, 130):
        before = factors.solves
        assert solved(factors, contacts(count))[0] < 1e-3
        solves.append(factors.solves - before)
    vain = np.array(solves) > OFTEN
    assert vain.tolist() == [False, True, False, True, False, False, False, True]
    assert factors.factorisations == len(solves)


def test_what_is_forgotten_is_not_used_again():
    factors = LaggedFactors("test_")
    solved(factors, SPRINGS)
    factors.forget()
    residual, _ = solved(factors, contacts(1))
    assert factors.factorisations == 2 and residual < 1e-10


@pytest.mark.parametrize("before", [False, True])
def test_a_matrix_that_cannot_be_factorised_is_told(before):
    factors = LaggedFactors("test_")
    if before:
        solved(factors, SPRINGS)
    singular = sp.lil_matrix(SPRINGS)
    singular[5, :] = 0.0
    singular[:, 5] = 0.0
    _, reason = solved(factors, sp.csr_matrix(singular))
    assert reason < 0
    residual, reason = solved(factors, SPRINGS)
    assert residual < 1e-3 and reason > 0
