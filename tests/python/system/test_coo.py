"""PETSc's COO matrices, reached through its library."""

import numpy as np
import scipy.sparse as sp
from petsc4py import PETSc

from braidx.system import coo


def make_matrix(size, rows, cols):
    matrix = PETSc.Mat().create(comm=PETSc.COMM_SELF)
    matrix.setSizes(((size, size), (size, size)))
    matrix.setType(PETSc.Mat.Type.AIJ)
    coo.preallocate(matrix, rows, cols)
    return matrix


def to_dense(matrix):
    indptr, indices, data = matrix.getValuesCSR()
    return sp.csr_matrix((data, indices, indptr), shape=matrix.getSize()).toarray()


def test_repeated_entries_are_summed_and_negative_ones_dropped():
    rows, cols = np.array([0, 1, 0, -1, 2, 2]), np.array([0, 1, 0, 1, -1, 0])
    matrix = make_matrix(3, rows, cols)
    for factor in (1.0, 2.0):  # values replace the ones before
        coo.set_values(matrix, factor * np.array([1.0, 2.0, 3.0, 50.0, 60.0, 4.0]))
        expected = factor * np.array([[4.0, 0, 0], [0, 2, 0], [4, 0, 0]])
        np.testing.assert_array_equal(to_dense(matrix), expected)
