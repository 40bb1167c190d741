"""Steps of Newton's method that take each other back."""

import numpy as np
import pytest
from mpi4py import MPI

from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem

EXPONENT = 0.45  # below a half full steps jump over the root, farther each time


class SteepSpring:
    """A force that is sign(x) |x|^EXPONENT: the steeper the nearer to the root."""

    pattern_version, spread = 1, None

    def set_state(self, q):
        self.q = q

    def add_residual(self, residual):
        residual += np.sign(self.q) * np.abs(self.q) ** EXPONENT

    def tangent_pattern(self):
        return np.arange(3), np.arange(3)

    def tangent_values(self):
        return EXPONENT * np.abs(self.q) ** (EXPONENT - 1.0)


def solve(halving):
    constraints = Constraints(3).resolve()
    system = GlobalSystem(MPI.COMM_SELF, [SteepSpring()], constraints, np.zeros(3))
    system.update_pattern()
    options = NewtonOptions(
        tolerance=1e-3, symmetric=False, least_force=1.0, max_step=100.0, halving=halving
    )
    newton = Newton(system, options, np.zeros(3, dtype=bool))
    return newton.solve(np.array([0.3, -0.2, 0.1]), search=False)


def test_steps_that_turn_back_are_shortened():
    q, result = solve(halving=True)
    assert result.converged and np.abs(q) ** EXPONENT == pytest.approx(0.0, abs=1e-3)
    q, result = solve(halving=False)
    assert not result.converged and np.abs(q).max() > 0.3
