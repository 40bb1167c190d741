"""Pseudo-transient continuation of systems of one or two unknowns, whose equilibria are known."""

from __future__ import annotations

import numpy as np
import pytest
from mpi4py import MPI

from braidx.solver.linear import FactorisedTangent
from braidx.solver.pseudo_transient import LEAST, MOST, PseudoTransient, StepOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.proximal import ProximalTerm


class Potential:
    """A term with a potential and its derivatives, of all unknowns."""

    pattern_version = 1
    spread = None

    def __init__(self, size, energy, gradient, hessian):
        self._size, self._energy = size, energy
        self._gradient, self._hessian = gradient, hessian

    def set_state(self, q):
        self._q = q

    def energy(self, own):
        return self._energy(self._q)

    def add_residual(self, residual):
        residual += self._gradient(self._q)

    def tangent_pattern(self):
        row, col = np.indices((self._size, self._size))
        return row.ravel(), col.ravel()

    def tangent_values(self):
        return np.asarray(self._hessian(self._q), dtype=float).ravel()


def steps_from(start, potential, metric=1.0, **limits):
    """Steps of a system of one potential, and the proximal term."""
    q = np.asarray(start, dtype=float)
    proximal = ProximalTerm(q.size)
    proximal.viscosity[:] = metric
    constraints = Constraints(q.size).resolve()
    system = GlobalSystem(MPI.COMM_SELF, [potential, proximal], constraints, np.zeros(q.size))
    tangent = FactorisedTangent(system)
    directors = np.zeros(q.size, dtype=bool)
    steps = PseudoTransient(system, proximal, tangent, StepOptions(**limits), directors)
    steps.restart(q)
    return steps


def solve(steps, tolerance=1e-10, most=60):
    """Norms of the residual, from the start to the first below the tolerance."""
    steps.residual()
    norms = [steps.norm]
    while steps.norm > tolerance:
        assert len(norms) <= most, f"no equilibrium after {most} steps, residual {steps.norm:.1e}"
        if steps.step():
            steps.residual()
            steps.adapt(norms[-1])
        norms.append(steps.norm)
    return norms


def double_well():
    """Two stable equilibria, -1 and 1; between them the stiffness is negative."""
    return Potential(
        1,
        lambda q: 0.25 * q[0] ** 4 - 0.5 * q[0] ** 2,
        lambda q: np.array([q[0] ** 3 - q[0]]),
        lambda q: [[3 * q[0] ** 2 - 1]],
    )


@pytest.mark.parametrize("start, end", [(0.1, 1.0), (-0.3, -1.0), (0.577, 1.0), (3.0, 1.0)])
def test_a_spring_of_negative_stiffness_is_left_for_the_well_beside_it(start, end):
    """Newton's method would go to the maximum at 0 from 0.1, and away from 0.577."""
    steps = steps_from([start], double_well())
    norms = solve(steps)
    assert steps.q[0] == pytest.approx(end)
    assert len(norms) <= 20


def test_the_potential_falls_with_every_step():
    steps = steps_from([0.577], double_well(), metric=0.1)
    energies, norm = [], np.inf
    while norm > 1e-10:
        norm = steps.residual() * steps.system.force_scale
        energies.append(steps.system.energy())
        if steps.step():
            steps.residual()
            steps.adapt(norm)
    assert np.all(np.diff(energies) <= 1e-15)


def two_bars(load):
    """The shallow truss of two bars (von Mises): height 1 over a half span of 5, a load on the apex downwards."""
    rest = np.hypot(5.0, 1.0)

    def length(q):
        return np.hypot(5.0, 1.0 - q[0])

    def force(q):
        stretch = length(q) - rest
        return -(1.0 - q[0]) / length(q) * stretch

    def stiffness(q):
        h, now = 1.0 - q[0], length(q)
        return (h / now) ** 2 + (now - rest) / now * (1.0 - (h / now) ** 2)

    return Potential(
        1,
        lambda q: 0.5 * (length(q) - rest) ** 2 - load * q[0],
        lambda q: np.array([force(q) - load]),
        lambda q: [[stiffness(q)]],
    )


def test_a_truss_snaps_through_beyond_its_limit_load():
    """Just below the limit load, found by a scan, it stays; just above it goes beyond the mirrored height."""
    scan = np.linspace(0.0, 1.0, 20001)
    h, now = 1.0 - scan, np.hypot(5.0, 1.0 - scan)
    limit = np.max(-h / now * (now - np.hypot(5.0, 1.0)))
    below, above = (steps_from([0.0], two_bars(f * limit), 1e-2) for f in (0.99, 1.01))
    assert len(solve(below, 1e-9)) <= 15
    assert 0.3 < below.q[0] < 0.5
    assert len(solve(above, 1e-9)) <= 40
    assert above.q[0] > 2.0


def spring_on_a_plane(force):
    """Two masses, a spring of length 1 between them and forces that pull it: nothing keeps them where they are."""
    return Potential(
        2,
        lambda q: 0.5 * (q[1] - q[0] - 1.0) ** 2 - force * (q[1] - q[0]),
        lambda q: (q[1] - q[0] - 1.0 - force) * np.array([-1.0, 1.0]),
        lambda q: [[1.0, -1.0], [-1.0, 1.0]],
    )


def test_what_nothing_holds_does_not_move_as_a_whole():
    steps = steps_from([0.2, 0.9], spring_on_a_plane(0.5))
    norms = solve(steps)
    assert steps.q[1] - steps.q[0] == pytest.approx(1.5)
    assert steps.q.sum() == pytest.approx(1.1)
    assert len(norms) <= 10


def test_no_step_is_longer_than_the_limit():
    steps = steps_from([3.0], double_well(), max_step=0.125)
    steps.residual()
    before = steps.q[0]
    assert steps.step()
    assert before - steps.q[0] == pytest.approx(0.125)


def test_the_damping_parameter_follows_the_residual_within_bounds():
    steps = steps_from([3.0], double_well())
    steps.residual()
    assert steps.damping == 1.0
    steps.adapt(2 * steps.norm)
    assert steps.damping == 0.5
    steps.adapt(1.01 * steps.norm, near=True)
    assert steps.damping == pytest.approx(0.05)
    steps.adapt(1e9 * steps.norm)
    assert steps.damping == LEAST
    steps.adapt(1e-12 * steps.norm)
    assert steps.damping == MOST


def test_the_metric_has_no_force_and_no_energy():
    steps = steps_from([0.2, 0.9], spring_on_a_plane(0.0), metric=1e6)
    assert steps.residual() * steps.system.force_scale == pytest.approx(0.3 * np.sqrt(2))
    assert steps.system.energy() == pytest.approx(0.5 * 0.3**2)


def test_a_direction_that_leads_up_damps_the_next_one():
    """With the tangent of another potential the first step goes uphill; a damping larger than it turns it."""
    hill = Potential(1, lambda q: q[0] ** 2, lambda q: 2 * q, lambda q: [[-5.0]])
    steps = steps_from([1.0], hill)
    steps.residual()
    assert not steps.step()
    assert steps.q[0] == 1.0 and steps.damping == 10.0
    assert steps.step()
    assert 0.0 < steps.q[0] < 1.0


def test_systems_solved_are_counted():
    steps = steps_from([3.0], double_well())
    norms = solve(steps)
    assert steps.tangent.solves == len(norms) - 1
