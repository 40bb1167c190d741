"""Stabilisation of the tangents of cables: its forces, stiffness and work."""

import numpy as np
import pytest

from braidx.system.proximal import ProximalTerm
from braidx.system.turning import Turning

SIZE = 12  # four nodes: two cables of two


@pytest.fixture
def term():
    turning = Turning(np.array([0, 6]), np.array([3, 9]), np.array([2.0, 4.0]))
    turning.viscosity = 8.0
    proximal = ProximalTerm(SIZE, turning=turning)
    rng = np.random.default_rng(0)
    proximal.start = proximal.anchor = rng.standard_normal(SIZE)
    proximal.viscosity[:] = 0.3
    return proximal


def residual(term, q):
    out = np.zeros(SIZE)
    term.set_state(q)
    term.add_residual(out)
    return out


def test_residual_is_half_the_gradient_of_the_work_and_the_tangent_its_derivative(term):
    q = np.random.default_rng(1).standard_normal(SIZE)
    tangent = np.zeros((SIZE, SIZE))
    np.add.at(tangent, term.tangent_pattern(), term.tangent_values())
    steps = 1e-5 * np.eye(SIZE)
    slopes = [(term.work(q + step) - term.work(q - step)) / 2e-5 for step in steps]
    assert residual(term, q) == pytest.approx(0.5 * np.array(slopes), abs=1e-9)
    bends = [(residual(term, q + step) - residual(term, q - step)) / 2e-5 for step in steps]
    assert tangent == pytest.approx(np.array(bends), abs=1e-9)


def test_a_small_turn_costs_its_square_and_a_translation_nothing(term):
    term.viscosity[:] = 0.0
    moved = np.zeros(SIZE)
    moved[0:6] = 0.7
    assert term.work(term.start + moved) == pytest.approx(0.0)
    moved[4] += 0.02  # 0.01 rad over 2 mm
    assert term.work(term.start + moved) == pytest.approx(8.0 * 0.01**2)


def test_one_process_of_several_gives_the_forces(term):
    silent = ProximalTerm(SIZE, rank=1, turning=term.turning)
    silent.start = silent.anchor = term.start
    q = term.start + 1.0
    assert not residual(silent, q).any() and len(silent.tangent_values()) == 0
    assert silent.work(q + np.arange(SIZE)) == pytest.approx(
        term.turning.work(1.0 + np.arange(SIZE)), rel=1e-12
    )
