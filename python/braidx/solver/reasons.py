"""Why a solve of PETSc's ended, in words."""

from __future__ import annotations

from petsc4py import PETSc

NOT_FACTORISED = 81  # PETSC_ERR_MAT_CH_ZRPVT: Cholesky met a pivot that is not positive
INDEFINITE = "the tangent is not positive definite"
UNSOLVED = "diverged linear solve"


def ended(code: int) -> str:
    """What a converged reason of SNES says."""
    names = {v: k for k, v in vars(PETSc.SNES.ConvergedReason).items() if isinstance(v, int)}
    return names.get(code, str(code)).lower().replace("_", " ")


def broken_off(error: PETSc.Error) -> str:
    """What an error says that broke a solve off.

    Raises:
        BaseException: The error itself where it is none of PETSc's, but of what was called back from within the solve.
    """
    while error.__cause__ is not None:
        if not isinstance(error.__cause__, PETSc.Error):
            raise error.__cause__
        error = error.__cause__
    return INDEFINITE if error.ierr == NOT_FACTORISED else f"PETSc error {error.ierr}"
