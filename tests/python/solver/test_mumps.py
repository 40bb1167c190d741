"""MUMPS gets more working space where its estimate was too little, as if that had been enough at once."""

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI
from petsc4py import PETSc
from test_lagged import petsc, solved

from braidx.bodies import CableBody
from braidx.rods import straight
from braidx.solver import mumps
from braidx.solver.lagged import LaggedFactors
from braidx.solver.newton import Newton, NewtonOptions
from braidx.solver.petsc_options import PREFIX
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.terms import BodyTerm, LoadTerm

# Less than the estimate, %: MUMPS takes negative numbers, too, and says -9 then.
TINY = -90
SIZE = 120
PIVOTS = sp.csr_matrix(
    sp.random(SIZE, SIZE, 0.05, random_state=1, data_rvs=np.random.default_rng(0).standard_normal)
    + 1e-3 * sp.eye(SIZE)
)


def solved_cable(**options):
    """A cable of 60 elements, stretched by a tenth and pulled across in its middle; state and outcome."""
    body = CableBody(MPI.COMM_SELF, [straight((0, 0, 0), (0, 0, 60), 60)], axial_stiffness=1e3)
    start = 1.1 * body.rest.ravel()
    held = np.zeros(len(start))
    held[-3:] = start[-3:]
    loads = LoadTerm(len(start))
    loads.loads[90] = 1.0
    constraints = Constraints(len(start))
    constraints.hold([0, 1, 2, 180, 181, 182])
    system = GlobalSystem(MPI.COMM_SELF, [BodyTerm(body, 0), loads], constraints.resolve(), held)
    system.update_pattern()
    return Newton(system, NewtonOptions(**options), np.zeros(len(start), dtype=bool)).solve(start)


@pytest.fixture
def too_little():
    """MUMPS begins with too little space, which is forgotten afterwards."""
    options = PETSc.Options(PREFIX)
    options[mumps.OPTION] = TINY
    yield options
    options.delValue(mumps.OPTION)


def test_factors_are_made_again_with_more(too_little):
    matrix = petsc(PIVOTS)
    right = matrix.createVecLeft()
    right.array[:] = np.arange(SIZE)
    found = mumps.solve_once(matrix, right).array
    assert found == pytest.approx(np.linalg.solve(PIVOTS.toarray(), np.arange(SIZE)), rel=1e-9)
    assert too_little.getInt(mumps.OPTION) >= mumps.FIRST


def test_lagged_factors_are_made_again_with_more(too_little):
    residual, reason = solved(LaggedFactors(PREFIX), PIVOTS)
    assert reason > 0 and residual < 1e-3
    assert too_little.getInt(mumps.OPTION) >= mumps.FIRST


@pytest.mark.parametrize("lagged", [False, True])
def test_newton_goes_on_with_more(too_little, lagged):
    """As many iterations as with enough: the equilibrium of a cable pulled across."""
    too_little[mumps.OPTION] = 50
    enough, usual = solved_cable(symmetric=False, lagged=lagged)
    too_little[mumps.OPTION] = TINY
    found, result = solved_cable(symmetric=False, lagged=lagged)
    assert result.converged and too_little.getInt(mumps.OPTION) >= mumps.FIRST
    assert result.iterations == usual.iterations
    assert usual.converged and found == pytest.approx(enough, abs=1e-12)


def test_no_more_than_there_is(too_little, monkeypatch):
    monkeypatch.setattr(mumps, "MOST", 0)
    with pytest.raises(MemoryError, match="MUMPS lacks memory for the factors of 177 unknowns"):
        solved_cable(symmetric=False)
