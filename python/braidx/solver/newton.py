"""One equilibrium for frozen contact elements: PETSc SNES on the free unknowns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from petsc4py import PETSc

from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from .lagged import LaggedFactors
from .mumps import grow_workspace
from .newton_result import NewtonResult
from .petsc_options import PREFIX, set_options
from .reasons import INDEFINITE, UNSOLVED, broken_off, ended
from .step_limit import StepLimit

LINE_SEARCH = "snes_linesearch_type"
VAIN = 3  # see NewtonOptions
HALVED = (
    0.5  # of a residual near round-off that an iteration has to take away to be worth another one
)
NOISE = 10.0  # times the estimate of round-off: the most that it was found to leave, of thin rods that hardly contract
PATIENT = 5  # the same where no search follows


@dataclass(frozen=True)
class NewtonOptions:
    """Options of the Newton iteration.

    Attributes:
        tolerance: Residual over force scale at which an equilibrium is accepted.
        max_iterations: Newton iterations before the solve counts as diverged.
        max_step: Largest change of a position in one iteration, mm; larger steps are scaled down.
        max_turn: Largest change of a director component in one iteration; those steps are cut one by one.
        symmetric: Whether the tangent is symmetric (Cholesky instead of LU).
        petsc: PETSc options passed through, without leading dash.
        least_force: Force scale that counts at least, N.
        round_off: Estimate of the norm that round-off leaves of internal forces, N; see `Newton.below_round_off`.
        vain: Full steps in a row, none of which comes nearer than the best before, after which steps are searched for.
        halving: Whether steps that take back the last one are halved (solver/step_limit.py).
        lagged: Whether factors of earlier tangents may serve where the tangent is not symmetric (solver/lagged.py).
    """

    tolerance: float = 1e-6
    max_iterations: int = 30
    max_step: float = 1.0
    max_turn: float = 0.3
    symmetric: bool = True
    petsc: Mapping[str, object] | None = None
    least_force: float = 0.0
    round_off: float = 0.0
    vain: int = VAIN
    halving: bool = False
    lagged: bool = False


class Newton:
    """Newton's method for a global system: with full steps and, if these lead away, once more with a line search.

    Contacts that open and close let the residual rise before it falls: full steps find out which they are in a few
    iterations, where a line search would shorten all of them. But nothing keeps full steps from getting lost.

    Attributes:
        directors: Whether an unknown belongs to a director, shape (num_unknowns,).
        symmetric: Whether the tangent is symmetric; a change takes effect with `renew`.
        bold: Whether full steps are tried first.
        indefinite: Whether the solver in use copes with an indefinite tangent, at a higher price.
        tolerance, max_iterations: As in the options, unless loosened for states only passed through.
        below_round_off: Whether iterations go on below the estimate of round-off, which is seldom reached, until one
            does not halve the residual: loads can be smaller.
        norm: Of the last residual, N.
        step: Norm of the last step, mm and, on directors, 1.
    """

    def __init__(self, system: GlobalSystem, options: NewtonOptions, directors: np.ndarray) -> None:
        self.system = system
        self.options = options
        self.directors = directors
        self.symmetric = options.symmetric
        self._residual = system.vector.duplicate()
        self._searching: PETSc.SNES | None = None
        self._full: PETSc.SNES | None = None
        self._lagged = LaggedFactors(PREFIX) if _may_lag(options) else None
        self.indefinite = False
        self.bold, self.below_round_off = True, False
        self._enough = self._iterations_left = 0.0
        self._least, self._in_vain, self._most_in_vain = np.inf, 0.0, np.inf
        self._limit = StepLimit(system.comm, options.max_step, options.max_turn, options.halving)
        self._came_from: Floats | None = None  # where the last tangent was made
        self._found: Floats = np.empty(0)  # and where that step, the last one, led
        self.norm, self.step = np.inf, 0.0
        self.restore_options()

    def restore_options(self) -> None:
        """Tolerance and number of iterations as the options say."""
        self.tolerance, self.max_iterations = self.options.tolerance, self.options.max_iterations

    @property
    def _lags(self) -> bool:
        """Whether factors of earlier tangents are used: not those that tell if a tangent is definite."""
        return self._lagged is not None and not self.symmetric

    def forget(self) -> None:
        """The next tangent is factorised: what comes does not depend on what was solved before."""
        if self._lagged is not None:
            self._lagged.forget()

    def foresee(self, start: Floats, found: Floats) -> None:
        """A step from `start`, with the tangent there, led to `found`, where the next solve is to begin."""
        self._came_from, self._found = start, found

    def renew(self, indefinite: bool = False) -> None:
        """Sets the solver up for the system's current matrix, which may be told to be indefinite."""
        self.indefinite = indefinite
        for snes in (self._searching, self._full):
            if snes is not None:
                snes.destroy()
        given = dict(self.options.petsc or {})
        self._searching = self._make({LINE_SEARCH: "bt", **given})
        self._full = None
        if LINE_SEARCH not in given:
            self._full = self._make({LINE_SEARCH: "basic", **given})
            self._full.setKSP(self._searching.getKSP())

    def _make(self, petsc: Mapping[str, object]) -> PETSc.SNES:
        snes = PETSc.SNES().create(self.system.comm)
        snes.setOptionsPrefix(PREFIX)
        snes.setFunction(self._function, self._residual)
        snes.setJacobian(self._jacobian, self.system.matrix)
        snes.setConvergenceTest(self._test)
        snes.setTolerances(max_it=10**6)  # _test decides
        snes.setLineSearchPreCheck(self._limit_step)
        ksp = snes.getKSP()
        ksp.setType("preonly")
        if self._lags:
            ksp.setOptionsPrefix(f"{PREFIX}outer_")
            ksp.getPC().setType("python")
            ksp.getPC().setPythonContext(self._lagged)
            set_options(petsc)
        else:
            set_options(petsc, self._choose_factors(ksp.getPC()))
        snes.setFromOptions()
        return snes

    def _choose_factors(self, factors: PETSc.PC) -> dict[str, object]:
        """Sets factors that are made in every iteration; options that go with them."""
        factors.setType("cholesky" if self.symmetric else "lu")
        definite = self.symmetric and self.system.comm.size == 1 and not self.indefinite
        factors.setFactorSolverType("cholmod" if definite else "mumps")
        # A failed factorisation is dealt with: CHOLMOD need not tell the user.
        return {"mat_cholmod_print": 0} if definite else {}

    def solve(
        self, q: Floats, enough: float = 0.0, search: bool = True
    ) -> tuple[Floats, NewtonResult]:
        """Equilibrium from the start q (all unknowns), shape (num_unknowns,), mm.

        Args:
            q: Where to start.
            enough: Relative residual that suffices where it is larger than `tolerance`.
            search: Whether a line search is tried where full steps lead away.
        Returns:
            All unknowns at the last iterate, and the outcome.
        """
        if self._searching is None:
            self.renew()
        self._enough = max(enough, self.tolerance)
        if not np.array_equal(q, self._found):
            self._came_from = None
        start, tried = self.system.free_values(q), None
        if self.bold and self._full is not None:
            self.system.scatter(start, self.system.vector)
            result = tried = self._run(
                self._full, most_in_vain=self.options.vain if search else PATIENT
            )
        if tried is None or (search and not (tried.converged or tried.exhausted)):
            if tried is not None and tried.reason == INDEFINITE:
                self.renew(indefinite=True)
            self.system.scatter(start, self.system.vector)
            result = self._run(self._searching)
            if result.reason == INDEFINITE and not self.indefinite:
                # Where yarns are about to slide off each other the tangent has a negative eigenvalue.
                self.renew(indefinite=True)
                result = self._run(self._searching, result.iterations)
            result = result if tried is None else result.after(tried)
        self._found = self.system.expand(self.system.gather(self.system.vector))
        return self._found.copy(), result

    def _run(
        self, snes: PETSc.SNES | None, before: int = 0, most_in_vain: float = np.inf
    ) -> NewtonResult:
        assert snes is not None
        self._iterations_left = self.max_iterations - before
        self._least, self._in_vain, self._most_in_vain = np.inf, 0, most_in_vain
        self._limit.restart()
        begun = self._lagged.solves if self._lagged is not None else 0
        error = None
        try:
            snes.solve(None, self.system.vector)
        except PETSc.Error as broken:
            error = broken
        iterations, solves = snes.getIterationNumber(), snes.getLinearSolveIterations()
        code = snes.getConvergedReason()
        converged, reason = error is None and code > 0, ended(code)
        if error is not None:
            self._leave_locked_vectors()
            reason = broken_off(error)
        elif reason == UNSOLVED:
            # MUMPS does not factorise again what it failed to, whatever the matrix is by then.
            grown, searching = grow_workspace(snes.getKSP().getPC()), snes is self._searching
            self.renew(self.indefinite)
            if grown:
                again = self._searching if searching else self._full
                return self._run(again, before + iterations, most_in_vain)
        if self._lags and self._lagged is not None:
            solves = self._lagged.solves - begun
        return NewtonResult(
            converged, before + iterations, before + solves, self._relative(), reason
        )

    def _leave_locked_vectors(self) -> None:
        """An error in the middle of a solve leaves its vectors locked, and what it was solved with in disorder."""
        values = self.system.vector.array_r.copy()
        self.system.vector = self.system.vector.duplicate()
        self.system.vector.array[:] = values
        self._residual = self.system.vector.duplicate()
        self.renew(self.indefinite)

    def residual(self, q: Floats) -> float:
        """Relative residual at q."""
        self.system.set_state(q)
        self.system.assemble_residual(self._residual)
        self.norm = self._residual.norm()
        return self._relative()

    def _relative(self) -> float:
        return 0.0 if self.norm <= NOISE * self.options.round_off else self.norm / self._scale()

    def _scale(self) -> float:
        return max(self.system.force_scale, self.options.least_force, 1e-300)

    def _is_enough(self, fell: bool) -> bool:
        """Whether the last residual is small beside the forces, or is round-off that does not fall any more."""
        noise = (0.0 if self.below_round_off else 1.0) if fell else NOISE
        return (
            self.norm <= noise * self.options.round_off or self.norm < self._enough * self._scale()
        )

    def _function(self, snes: PETSc.SNES, x: PETSc.Vec, f: PETSc.Vec) -> None:
        self.system.set_state(self.system.expand(self.system.gather(x)))
        self.system.assemble_residual(f)

    def _jacobian(
        self, snes: PETSc.SNES, x: PETSc.Vec, matrix: PETSc.Mat, preconditioner: PETSc.Mat
    ) -> None:
        q = self.system.expand(self.system.gather(x))
        self.system.set_state(q)
        # A line search goes down the residual itself, and so needs its derivative.
        before = self._came_from if snes is not self._searching else None
        self.system.set_step(np.zeros_like(q) if before is None else q - before)
        self._came_from = q
        self.system.assemble_tangent()

    def _test(self, snes: PETSc.SNES, iteration: int, norms: tuple[float, float, float]) -> int:
        last, self.norm = self.norm, norms[2]
        if not np.isfinite(self.norm):
            return PETSc.SNES.ConvergedReason.DIVERGED_FNORM_NAN
        if self._is_enough(fell=iteration == 0 or self.norm < HALVED * last):
            return PETSc.SNES.ConvergedReason.CONVERGED_FNORM_RELATIVE
        if iteration >= self._iterations_left:
            return PETSc.SNES.ConvergedReason.DIVERGED_MAX_IT
        self._in_vain = 0 if self.norm < self._least else self._in_vain + 1
        self._least = min(self._least, self.norm)
        if self._in_vain >= self._most_in_vain:
            return PETSc.SNES.ConvergedReason.DIVERGED_LOCAL_MIN
        return PETSc.SNES.ConvergedReason.ITERATING

    def _limit_step(self, x: PETSc.Vec, step: PETSc.Vec) -> bool:
        """PETSc subtracts the step: x - step."""
        first, last = step.getOwnershipRange()
        # Which unknowns are free may differ from increment to increment.
        turning = self.directors[self.system.constraints.free[first:last]]
        self._limit.apply(step.array, turning)
        self.step = step.norm()
        return True


def _may_lag(options: NewtonOptions) -> bool:
    """Unless the user chooses a solver."""
    chosen = any(key.startswith(("ksp_", "pc_")) for key in options.petsc or {})
    return options.lagged and not chosen
