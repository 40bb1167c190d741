"""A solve that fails leaves the solver in order: a tangent that cannot be factorised, an error within."""

import numpy as np
import pytest
from mpi4py import MPI

from braidx.bodies import CableBody
from braidx.rods import straight
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


class Loose(BodyTerm):
    """A body whose tangent is zero as long as it is told so."""

    loose = False

    def tangent_values(self):
        values = super().tangent_values()
        return 0.0 * values if self.loose else values


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
    terms = [Loose(body, 0), loads]
    system = GlobalSystem(MPI.COMM_SELF, terms, constraints.resolve(), held_at(2.2))
    system.update_pattern()
    return Newton(system, NewtonOptions(**options), np.zeros(9, dtype=bool)), loads


@pytest.mark.parametrize("lagged", [False, True])
def test_a_tangent_that_could_not_be_factorised_does_not_spoil_the_next(lagged):
    newton, _ = held_cable(symmetric=False, lagged=lagged)
    newton.system.terms[0].loose = True
    _, failed = newton.solve(middle_at(1.1))
    assert (failed.converged, failed.reason) == (False, UNSOLVED)
    newton.system.terms[0].loose = False
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
