"""The residual of a whole system is the gradient of its energy."""

import numpy as np
import pytest

from braidx.rods import Scheme
from braidx.rods.couples import CoupleTerm
from braidx.rods.inertia import InertiaTerm
from test_images import small_rope
from test_rope_derivatives import reduced_residual, strand_model


def energy_at(system, free_values):
    system.set_state(system.expand(free_values))
    return system.energy()


def relative_error(system, p, seed=6):
    """Of the residual in random directions, against central differences of the energy."""
    rng, residual, errors = np.random.default_rng(seed), reduced_residual(system, p), []
    for _ in range(4):
        step = 1e-6 * rng.standard_normal(len(p))
        change = energy_at(system, p + step) - energy_at(system, p - step)
        errors.append(abs(change - 2 * residual @ step) / np.linalg.norm(step))
    return max(errors) / np.linalg.norm(residual)


@pytest.mark.parametrize("transverse", ["periodic", "fixed", "free"])
@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("model", ["cable", "beam"])
def test_residual_is_the_gradient_of_the_energy(model, friction, transverse):
    rope_model, q = strand_model(model, friction, transverse)
    system, contact = rope_model.system, rope_model.contact
    p = system.free_values(q)
    q = system.expand(p)
    contact.lag(q)
    found = contact.results(q)
    assert (found["gap"] < 0).sum() > 20
    assert np.all(contact.arrays()["follows"] != 0)
    assert relative_error(system, p) < 1e-6


@pytest.mark.parametrize("model", ["cable", "beam"])
def test_energy_of_a_rope_with_images(model):
    """Contact elements with an image occur twice, and half of each counts."""
    rope, q = small_rope(model)
    system, contact = rope.system, rope.contact
    contact.lag(q)
    assert contact.layout.is_image.sum() == 6
    assert relative_error(system, system.free_values(q)) < 1e-6


def test_energy_of_inertia():
    rng = np.random.default_rng(1)
    for scheme in (Scheme.generalised_alpha(0.5), Scheme.backward_euler()):
        term = InertiaTerm(rng.uniform(1, 2, 6), scheme)
        term.velocity, term.acceleration, term.forces = rng.standard_normal((3, 6))
        start, q, step = rng.standard_normal(6), rng.standard_normal(6), 1e-6 * np.ones(6)
        term.begin(start, 0.1)
        energies = []
        for sign in (1, -1):
            term.set_state(q + sign * step)
            energies.append(term.energy(np.ones(6)))
        forces = np.zeros(6)
        term.set_state(q)
        term.add_residual(forces)
        assert energies[0] - energies[1] == pytest.approx(2 * forces @ step, rel=1e-7)


def test_couples_have_no_potential():
    term = CoupleTerm(np.arange(6)[None])
    term.set_state(np.eye(3)[:2].ravel())
    assert term.energy(np.ones(6)) == 0.0
    term.couples[0] = (0, 0, 1.0)
    assert np.isnan(term.energy(np.ones(6)))
