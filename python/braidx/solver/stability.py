"""Stability of an equilibrium: how many directions its potential falls in."""

from __future__ import annotations

from petsc4py import PETSc

from ..system.global_system import GlobalSystem

ROUND_OFF = (
    1e-12  # of a row's diagonal, a thousand times that of the factors: softer modes are indifferent
)


def negative_pivots(system: GlobalSystem) -> int:
    """Number of negative pivots of the symmetric part of the tangent, at the state that `system` has.

    By Sylvester's law it is the number of negative eigenvalues: of directions in which the equilibrium is unstable.

    Raises:
        ArithmeticError: If the tangent cannot be factorised.
    """
    if not system.num_free:
        return 0
    system.update_pattern()
    system.set_step(0.0 * system.q)
    system.assemble_tangent()
    assert system.matrix is not None
    transposed = system.matrix.transpose(PETSc.Mat())
    symmetric = system.matrix.copy()
    symmetric.axpy(1.0, transposed, PETSc.Mat.Structure.DIFFERENT_NONZERO_PATTERN)
    diagonal = symmetric.getDiagonal()
    diagonal.abs()
    diagonal.scale(ROUND_OFF)
    symmetric.setDiagonal(diagonal, PETSc.InsertMode.ADD_VALUES)
    factors = PETSc.PC().create(comm=symmetric.comm)
    factors.setOperators(symmetric)
    factors.setType("cholesky")
    factors.setFactorSolverType("mumps")
    factors.setFactorSetUpSolverType()
    factors.getFactorMatrix().setMumpsIcntl(24, 1)  # PETSc asks for it where pivots are counted
    try:
        factors.setUp()
        if factors.getFailedReason():
            raise ArithmeticError("the tangent at the state found cannot be factorised")
        return int(factors.getFactorMatrix().getInertia()[0])
    finally:
        for thing in (factors, symmetric, transposed):
            thing.destroy()
