"""Newton's method: quadratic near the solution, bounded far from it, options handed through."""

import numpy as np
import pytest
from mpi4py import MPI

from braidx.bodies import CableBody, SolidBody, YarnMaterial
from braidx.meshing import rectangle, sweep
from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.terms import BodyTerm, LoadTerm

LENGTH, NODES, TENSION, LOAD = 10.0, 11, 100.0, 3.0


def loaded_cable(**options):
    """A cable along z, its ends held, under a load across it in the middle."""
    line = np.linspace([0.0, 0, 0], [0, 0, LENGTH], NODES)
    body = CableBody(MPI.COMM_SELF, [line], axial_stiffness=1e4, tension=TENSION)
    loads = LoadTerm(body.num_unknowns)
    loads.loads[3 * (NODES // 2)] = LOAD
    constraints = Constraints(body.num_unknowns)
    constraints.hold([0, 1, 2, *range(body.num_unknowns - 3, body.num_unknowns)])
    values = np.zeros(body.num_unknowns)
    values[-1] = LENGTH
    system = GlobalSystem(MPI.COMM_SELF, [BodyTerm(body, 0), loads], constraints.resolve(), values)
    system.update_pattern()
    newton = Newton(system, NewtonOptions(**options), np.zeros(body.num_unknowns, dtype=bool))
    return newton, body.rest.ravel().copy()


def sag(q):
    return q.reshape(-1, 3)[NODES // 2, 0]


@pytest.mark.parametrize(("symmetric", "lagged"), [(True, False), (False, False), (False, True)])
def test_cable_under_a_load(symmetric, lagged):
    """2 T sin a = P, with the tension of the stretched cable."""
    newton, q = loaded_cable(symmetric=symmetric, lagged=lagged, tolerance=1e-10)
    q, result = newton.solve(q)
    assert result.converged and result.residual < 1e-10
    half = np.hypot(LENGTH / 2, sag(q))
    tension = TENSION + 1e4 * (half / (LENGTH / 2) - 1)
    assert 2 * tension * sag(q) / half == pytest.approx(LOAD, rel=1e-8)
    assert newton.residual(q) == pytest.approx(result.residual, abs=1e-12)
    assert result.iterations <= 6
    if not lagged:
        assert result.linear_solves == result.iterations


def test_held_unknowns_tell_the_reaction():
    newton, q = loaded_cable()
    q, _ = newton.solve(q)
    newton.system.set_state(q)
    ends = newton.system.residual().reshape(-1, 3)[[0, -1]]
    assert ends[:, 0] == pytest.approx([-LOAD / 2, -LOAD / 2], rel=1e-5)


def test_steps_are_limited():
    steps = []

    class Recording(Newton):
        def _function(self, snes, x, f):
            steps.append(x.array_r.copy())
            super()._function(snes, x, f)

    newton, q = loaded_cable(max_step=0.01)
    newton.__class__ = Recording
    _, result = newton.solve(q)
    assert result.converged
    assert np.abs(np.diff(steps, axis=0)).max() <= 0.01 * (1 + 1e-9)
    assert result.iterations > 6


def test_iterations_that_run_out_are_told():
    newton, q = loaded_cable(max_step=0.01, max_iterations=2)
    found, result = newton.solve(q)
    assert not result.converged and result.iterations == 2
    assert "max it" in result.reason
    assert sag(found) > 0  # the last iterate


def test_any_option_of_petsc_is_handed_through_and_does_not_stay():
    iterative = {"ksp_type": "cg", "pc_type": "jacobi"}
    solves = []
    for petsc in (iterative, None):
        newton, q = loaded_cable(petsc=petsc)
        _, result = newton.solve(q)
        assert result.converged
        solves.append(result.linear_solves / result.iterations)
    assert solves[0] > 1 and solves[1] == 1


def test_equilibrium_without_stress():
    """A bar moved as a whole: forces are round-off, and small against the least that counts alone."""
    line = np.linspace([0.0, 0, 0], [0, 0, 4.0], 5)
    mesh = sweep(line, rectangle(1.0, 1.0))
    body = SolidBody(MPI.COMM_SELF, mesh, material=YarnMaterial.isotropic(100.0, 0.3))
    ends = 3 * mesh.sweeps[0].layers[[0, -1]].reshape(-1, 1) + np.arange(3)
    constraints, values = Constraints(body.num_unknowns), np.zeros(body.num_unknowns)
    constraints.hold(ends.ravel())
    values[ends] = body.rest.ravel()[ends] + [0.1, 0.0, 0.0]
    system = GlobalSystem(MPI.COMM_SELF, [BodyTerm(body, 0)], constraints.resolve(), values)
    system.update_pattern()
    free = np.zeros(body.num_unknowns, dtype=bool)
    newton = Newton(system, NewtonOptions(least_force=1e-3), free)
    q, result = newton.solve(body.rest.ravel())
    assert q.reshape(-1, 3) == pytest.approx(body.rest + [0.1, 0.0, 0.0], abs=1e-9)
    assert result.converged
