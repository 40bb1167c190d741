"""A solve that fails leaves the solver in order: a tangent that cannot be factorised, an error within."""

import numpy as np
import pytest
from mpi4py import MPI

from braidx.bodies import CableBody
from braidx.forms.cable import SLACK
from braidx.rods import Cable, NotConverged, Rods, straight
from braidx.solver.newton import Newton, NewtonOptions
from braidx.solver.reasons import UNSOLVED
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.terms import BodyTerm, LoadTerm


class Failing(LoadTerm):
    """Loads that fail once, the next time that they are asked for."""

    fails = False

    def add_residual(self, residual):
        if self.fails:
            self.fails = False
            raise ArithmeticError("told to fail")
        super().add_residual(residual)


def held_at(end):
    """Its ends, and zeros."""
    return np.array([0.0, 0, 0, 0, 0, 0, 0, 0, end])


def middle_at(z):
    """A state of its middle."""
    return np.array([0.0, 0, 0, 0, 0, z, 0, 0, 0])


def held_cable(**options):
    """A cable of two elements along z, pulled across in its middle."""
    body = CableBody(MPI.COMM_SELF, [straight((0, 0, 0), (0, 0, 2), 2)], axial_stiffness=1e3)
    loads = Failing(9)
    loads.loads[3] = 1.0
    constraints = Constraints(9)
    constraints.hold([0, 1, 2, 6, 7, 8])
    terms = [BodyTerm(body, 0), loads]
    system = GlobalSystem(MPI.COMM_SELF, terms, constraints.resolve(), held_at(2.2))
    system.update_pattern()
    return Newton(system, NewtonOptions(**options), np.zeros(9, dtype=bool)), loads


def test_a_singular_tangent_is_told_and_leaves_the_solver_in_order():
    """A cable without tension has no stiffness across: first it finds no equilibrium, then, pulled taut, it does."""
    rods = Rods([Cable(straight((0, 0, 0), (10, 0, 0), 5), 0.1, 1e3, degree=1)])
    rods.pin(0, [0, -1])
    rods.force(0, 2, (0, 1e-3, 0))
    with pytest.raises(NotConverged):
        rods.solve(max_cuts=2)
    rods.force(0, 2, (0, 0, 0))
    rods.move(0, -1, by=(0.1, 0, 0))
    rods.solve(guess=rods.layout.rest * np.tile([1.01, 1.0, 1.0], 6))
    assert rods.tension(0) == pytest.approx(np.full(5, 1e3 * (0.01 - SLACK)), rel=1e-6)


@pytest.mark.parametrize("lagged", [False, True])
def test_a_tangent_that_could_not_be_factorised_does_not_spoil_the_next(lagged):
    newton, _ = held_cable(symmetric=False, lagged=lagged)
    newton.system.constraint_values = held_at(1.8)
    _, failed = newton.solve(middle_at(0.9))
    assert (failed.converged, failed.reason) == (False, UNSOLVED)
    newton.system.constraint_values = held_at(2.2)
    _, result = newton.solve(middle_at(1.1))
    assert result.converged and result.reason == "converged fnorm relative"


@pytest.mark.parametrize("lagged", [False, True])
def test_an_error_within_a_solve_does_not_spoil_the_next(lagged):
    newton, loads = held_cable(symmetric=False, lagged=lagged)
    expected, _ = newton.solve(middle_at(1.1))
    loads.fails = True
    with pytest.raises(ArithmeticError, match="told to fail"):
        newton.solve(middle_at(1.1))
    found, result = newton.solve(middle_at(1.1))
    assert result.converged
    assert found == pytest.approx(expected, abs=1e-12)
