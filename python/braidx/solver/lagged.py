"""Linear systems solved by GMRES, with the factors of an earlier tangent for a preconditioner.

Between iterations of an increment few contacts open or close, so that the factors of one tangent serve many: an
iteration of GMRES costs one solution with the factors, a fraction of what their computation does. Where many do, as
when a rope begins to bend, GMRES is not tried again for one system, then for three, for seven.
"""

from __future__ import annotations

from petsc4py import PETSc

from .mumps import grow_workspace

OFTEN = 20  # iterations of GMRES after which new factors are due
MOST = 25  # iterations after which they are made at once: about what new factors cost
REDUCTION = 1e-3  # of the residual of the linear system: contacts change more in an iteration of Newton's method


class LaggedFactors:
    """PETSc preconditioner (a Python context) that solves the system itself.

    Attributes:
        solves: Solutions with factors so far.
        factorisations: How often factors were computed so far.

    Args:
        prefix: Of the options that PETSc is given for the factors.
    """

    def __init__(self, prefix: str) -> None:
        self.solves = self.factorisations = 0
        self._prefix, self._stale = prefix, True
        self._untried = self._failures = (
            0  # systems left that GMRES is not tried for; how many were the last time
        )
        self._ksp: PETSc.KSP | None = None
        self._size = 0

    def forget(self) -> None:
        """The next system gets factors of its own, and nothing is left of what was learnt."""
        self._stale = True
        self._untried = self._failures = 0

    def apply(self, pc: PETSc.PC, right: PETSc.Vec, solution: PETSc.Vec) -> None:
        """Solves with the current matrix; tells the preconditioner where that fails."""
        matrix, _ = pc.getOperators()
        ksp = self._solver(matrix)
        ksp.setOperators(matrix)
        if self._untried:
            self._untried -= 1
        elif not self._stale:
            if self._solve(ksp, right, solution):
                self._failures = 0
                return
            self._untried = self._failures = 2 * self._failures + 1
        self._stale = True
        self._solve(ksp, right, solution)
        while grow_workspace(ksp.getPC()):
            self._discard()
            ksp = self._solver(matrix)
            ksp.setOperators(matrix)
            self._solve(ksp, right, solution)
        failed = ksp.getPC().getFailedReason()
        pc.setFailedReason(failed)
        if failed:
            # MUMPS does not factorise again what it failed to, whatever the matrix is by then.
            self._discard()

    def _discard(self) -> None:
        if self._ksp is not None:
            self._ksp.destroy()
        self._ksp, self._stale = None, True

    def _solve(self, ksp: PETSc.KSP, right: PETSc.Vec, solution: PETSc.Vec) -> bool:
        self.factorisations += self._stale
        ksp.getPC().setReusePreconditioner(not self._stale)
        ksp.solve(right, solution)
        iterations = ksp.getIterationNumber()
        self.solves += iterations
        self._stale = iterations > OFTEN
        return bool(ksp.getConvergedReason() > 0)

    def _solver(self, matrix: PETSc.Mat) -> PETSc.KSP:
        """GMRES with factors; anew where the number of unknowns has changed."""
        if self._ksp is not None and self._size == matrix.size[0]:
            return self._ksp
        self._discard()
        ksp = self._ksp = PETSc.KSP().create(matrix.comm)
        self._size = matrix.size[0]
        ksp.setOptionsPrefix(self._prefix)
        ksp.setType("gmres")
        ksp.setPCSide(PETSc.PC.Side.RIGHT)  # residuals are those of the system
        ksp.setTolerances(rtol=REDUCTION, max_it=MOST)
        ksp.setGMRESRestart(MOST)
        factors = ksp.getPC()
        factors.setType("lu")
        factors.setFactorSolverType("mumps")
        ksp.setFromOptions()
        return ksp
