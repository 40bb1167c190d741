"""Steps through time on masses and springs: exact flights, orders of convergence, what becomes of energy."""

import numpy as np
import pytest

from braidx.rods import Scheme
from braidx.rods.inertia import InertiaTerm

MASS, SPRING = np.array([2.0]), 8.0  # 2 rad/s
SCHEMES = [
    Scheme.generalised_alpha(),
    Scheme.generalised_alpha(1.0),
    Scheme.generalised_alpha(0.0),
    Scheme.backward_euler(),
]


def march(scheme, steps, duration, q, velocity=0.0, spring=SPRING, load=0.0):
    """Steps of a mass on a spring under a load from the start on; shape (steps, 2): position and velocity."""
    q, states = np.array([q]), []
    term = InertiaTerm(MASS, scheme)
    term.velocity[:] = velocity
    term.forces = spring * q - load
    term.acceleration = -term.forces / MASS
    for _ in range(steps):
        term.begin(q, duration / steps)
        residual = spring * q - load
        term.set_state(q)
        term.add_residual(residual)
        q = q - residual / (spring + term.tangent_values())
        term.end(q, spring * q - load)
        states.append((q[0], term.velocity[0]))
    return np.array(states)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_free_flight_is_exact(scheme):
    states = march(scheme, 7, 2.0, q=1.0, velocity=3.0, spring=0.0)
    assert states[-1] == pytest.approx([7.0, 3.0], rel=1e-12)


@pytest.mark.parametrize("scheme", SCHEMES[:3])
def test_fall_is_exact(scheme):
    q, velocity = march(scheme, 7, 2.0, q=0.0, spring=0.0, load=5.0)[-1]
    assert (q, velocity) == pytest.approx((5.0, 5.0), rel=1e-12)


@pytest.mark.parametrize("scheme, order", zip(SCHEMES, (2, 2, 2, 1)))
def test_order_of_an_oscillation(scheme, order):
    """x = cos 2t: positions and velocities."""
    exact = np.array([np.cos(3.0), -2.0 * np.sin(3.0)])
    errors = [np.abs(march(scheme, n, 1.5, q=1.0)[-1] - exact).max() for n in (200, 400)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1)


def test_radius_1_keeps_energy_and_others_take_it():
    def energy(scheme):
        q, v = march(scheme, 100, 30.0, q=1.0).T
        return 0.5 * SPRING * q**2 + 0.5 * MASS * v**2

    before = 0.5 * SPRING
    assert energy(Scheme.generalised_alpha(1.0)) == pytest.approx(np.full(100, before), rel=1e-12)
    assert energy(Scheme.backward_euler())[-1] < energy(Scheme.generalised_alpha(0.8))[-1] < before


@pytest.mark.parametrize("radius", [0.0, 0.5, 0.8])
def test_fast_motion_shrinks_by_the_spectral_radius(radius):
    states = march(Scheme.generalised_alpha(radius), 40, 40.0, q=1.0, spring=1e12)
    size = np.abs(states[:, 0]) + 1e-300
    # A double root: 40 steps shrink it by the power and grow it by their number.
    assert size[-1] <= max(100.0 * radius**40, 1e-9)


@pytest.mark.parametrize("radius", [-0.1, 1.1])
def test_impossible_radius(radius):
    with pytest.raises(ValueError, match="spectral_radius is"):
        Scheme.generalised_alpha(radius)


def test_tangent_is_the_derivative_of_the_residual():
    rng = np.random.default_rng(0)
    term = InertiaTerm(rng.random(4), Scheme.generalised_alpha(0.6))
    term.velocity, term.acceleration, term.forces = rng.standard_normal((3, 4))
    term.begin(np.zeros(4), 0.3)

    def residual(q):
        out = np.zeros(4)
        term.set_state(q)
        term.add_residual(out)
        return out

    tangent = np.zeros((4, 4))
    np.add.at(tangent, term.tangent_pattern(), term.tangent_values())
    slopes = [residual(step) - residual(-step) for step in 0.5 * np.eye(4)]
    assert tangent == pytest.approx(np.transpose(slopes), rel=1e-9, abs=1e-12)


def test_other_processes_give_nothing():
    term = InertiaTerm(np.ones(3), Scheme.backward_euler(), rank=1)
    term.begin(np.zeros(3), 0.1)
    term.set_state(np.ones(3))
    out = np.zeros(3)
    term.add_residual(out)
    assert not out.any() and term.tangent_values().size == 0
