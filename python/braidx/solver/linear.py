"""Linear systems with the tangent, solved with factors of its own."""

from __future__ import annotations

from collections.abc import Mapping

from petsc4py import PETSc

from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from .mumps import grow_workspace
from .petsc_options import PREFIX, set_options
from .reasons import INDEFINITE, broken_off


class FactorisedTangent:
    """Solves systems with the current tangent of a global system, factorised anew each time.

    Attributes:
        solves: Systems solved so far.

    Args:
        system: Whose tangent it is.
        petsc: PETSc options passed through, without leading dash.
    """

    def __init__(self, system: GlobalSystem, petsc: Mapping[str, object] | None = None) -> None:
        self.solves = 0
        self._system, self._petsc = system, dict(petsc or {})
        self._ksp: PETSc.KSP | None = None
        self._made_for: tuple[object, bool] = (None, False)

    def solve(self, right: Floats, symmetric: bool) -> Floats | None:
        """Solution for a right-hand side, shapes (num_free,), the same on all processes.

        Args:
            right: Equal on all processes.
            symmetric: Whether the tangent is, and positive definite.
        Returns:
            The solution; None where the tangent is singular, or `symmetric` and not positive definite.
        """
        system = self._system
        vector, solution = system.vector.duplicate(), system.vector.duplicate()
        system.scatter(right, vector)
        self.solves += 1
        try:
            solved = self._solve(vector, solution, symmetric)
            return system.gather(solution) if solved else None
        finally:
            vector.destroy()
            solution.destroy()

    def _solve(self, right: PETSc.Vec, solution: PETSc.Vec, symmetric: bool) -> bool:
        while True:
            ksp = self._solver(symmetric)
            try:
                ksp.solve(right, solution)
            except PETSc.Error as error:
                self.forget()
                if broken_off(error) != INDEFINITE:
                    raise
                return False
            if not grow_workspace(ksp.getPC()):
                break
            self.forget()
        solved = bool(ksp.getConvergedReason() > 0)
        if not solved:
            # MUMPS does not factorise again what it failed to, whatever the matrix is by then.
            self.forget()
        return solved

    def forget(self) -> None:
        """The next system gets a solver of its own."""
        if self._ksp is not None:
            self._ksp.destroy()
        self._ksp = None

    def _solver(self, symmetric: bool) -> PETSc.KSP:
        """The solver for the current matrix."""
        matrix = self._system.matrix
        assert matrix is not None
        if self._ksp is not None and self._made_for == (matrix, symmetric):
            self._ksp.setOperators(matrix)
            return self._ksp
        self.forget()
        ksp = self._ksp = PETSc.KSP().create(matrix.comm)
        self._made_for = matrix, symmetric
        ksp.setOptionsPrefix(PREFIX)
        ksp.setOperators(matrix)
        ksp.setType("preonly")
        factors = ksp.getPC()
        factors.setType("cholesky" if symmetric else "lu")
        by_cholmod = symmetric and matrix.comm.size == 1
        factors.setFactorSolverType("cholmod" if by_cholmod else "mumps")
        # A failed factorisation is dealt with: CHOLMOD need not tell the user.
        set_options(self._petsc, {"mat_cholmod_print": 0} if by_cholmod else {})
        ksp.setFromOptions()
        return ksp
