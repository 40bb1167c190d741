"""Memory of MUMPS, which estimates its working space before it knows the pivots; where it falls short, it gets more.

Errors are those of INFOG(1) in the MUMPS users' guide, chapter 8.
"""

from __future__ import annotations

from petsc4py import PETSc

from .petsc_options import PREFIX

SHORT = (-8, -9, -17, -20)  # the guide's cure is a larger ICNTL(14)
LACKING = (-13, -19)  # the machine's memory, or the user's limit to it (ICNTL(23)), is used up
OPTION = "mat_mumps_icntl_14"  # working space beyond the estimate, %
FIRST = 50  # %, more than the 20 to 35 that MUMPS begins with
MOST = 1600  # %: five doublings; an estimate that falls short by more is none


def grow_workspace(factors: PETSc.PC) -> bool:
    """Whether MUMPS ran out of working space; factors made anew begin with twice as much beyond the estimate.

    The solver that failed does not factorise again, whatever its space. All processes see the same error.

    Raises:
        MemoryError: If there is none left to give.
    """
    if factors.getFactorSolverType() != "mumps":
        return False
    matrix = factors.getFactorMatrix()
    error = matrix.getMumpsInfog(1)
    if error not in SHORT + LACKING:
        return False
    options = PETSc.Options(PREFIX)
    percent = max(2 * options.getInt(OPTION, 0), FIRST)
    if error in LACKING or percent > MOST:
        raise MemoryError(
            f"MUMPS lacks memory for the factors of {matrix.size[0]} unknowns (its error {error}); take fewer "
            "elements, or a machine with more memory"
        )
    options[OPTION] = percent
    return True


def solve_once(matrix: PETSc.Mat, right: PETSc.Vec) -> PETSc.Vec:
    """Solution of a linear system with an LU factorisation that nothing else needs."""
    solution = right.duplicate()
    grown = True
    while grown:
        ksp = PETSc.KSP().create(matrix.comm)
        ksp.setOptionsPrefix(PREFIX)
        ksp.setOperators(matrix)
        ksp.setType("preonly")
        ksp.getPC().setType("lu")
        ksp.getPC().setFactorSolverType("mumps")
        ksp.solve(right, solution)
        grown = grow_workspace(ksp.getPC())
        ksp.destroy()
    return solution
