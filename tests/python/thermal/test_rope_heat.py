"""Conduction in a cylinder against closed forms, and the balance of energy."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
import started
from mpi4py import MPI

from braidx.thermal import RopeHeat, ThermalMaterial

ROPE = ThermalMaterial(10.0, 0.3, 700.0, 1800.0, 25.0, 20.0)
RADIUS, LENGTH = 6.0, 40.0


def cylinder(material: ThermalMaterial = ROPE, bore: float = 0.0, cells=(6, 8)) -> RopeHeat:
    radial = np.linspace(bore, RADIUS, cells[0] + 1)
    axial = np.linspace(0.0, LENGTH, cells[1] + 1) ** 1.2 / LENGTH**0.2  # uneven on purpose
    return RopeHeat(MPI.COMM_WORLD, radial, axial, material)


def test_units_are_those_of_mm() -> None:
    assert ROPE.along == pytest.approx(0.010) and ROPE.across == pytest.approx(3e-4)
    assert ROPE.capacity == pytest.approx(1.26e-3) and ROPE.transfer == pytest.approx(2.5e-5)


def test_steady_state_of_a_uniform_source() -> None:
    """T = ambient + q R / (2 h) + q (R^2 - r^2) / (4 k): quadratic, hence exact here."""
    model, q = cylinder(), 1e-4
    model.set_source(np.full(model.num_cells, q))
    r, _ = model.nodes
    expected = 20.0 + q * RADIUS / (2 * ROPE.transfer) + q * (RADIUS**2 - r**2) / (4 * ROPE.across)
    np.testing.assert_allclose(model.steady(), np.tile(expected[:, None], 17), rtol=1e-10)
    assert model.power.sum() == pytest.approx(q * np.pi * RADIUS**2 * LENGTH, rel=1e-12)


def test_steady_state_of_a_hollow_rope() -> None:
    """With an insulated bore of radius a: + q a^2 / (2 k) ln(r / R), and the surface gives off less."""
    q, a = 1e-4, 2.0
    errors = []
    for count in (4, 8):
        model = cylinder(bore=a, cells=(count, 2))
        model.set_source(np.full(model.num_cells, q))
        r, _ = model.nodes
        expected = 20.0 + q * (RADIUS**2 - a**2) / (2 * RADIUS * ROPE.transfer)
        expected = expected + q * (RADIUS**2 - r**2) / (4 * ROPE.across)
        expected = expected + q * a**2 / (2 * ROPE.across) * np.log(r / RADIUS)
        errors.append(np.abs(model.steady() - expected[:, None]).max())
    assert errors[0] < 2e-3 and errors[1] < errors[0] / 7


def test_conduction_along_the_axis() -> None:
    """A source in one half: cosh and sinh of z over sqrt(k R / (2 h)) where T hardly varies in r."""
    material = ThermalMaterial(10.0, 1000.0, 700.0, 1800.0, 25.0, 0.0)
    model = cylinder(material, cells=(2, 40))
    q, edges = 1e-4, model.axial_edges
    warm = np.clip((edges[1:] - LENGTH / 2) / np.diff(edges), 0.0, 1.0)  # share of each cell
    model.set_source(q * np.tile(warm, (2, 1)))
    _, z = model.nodes
    decay = np.sqrt(material.along * RADIUS / (2 * material.transfer))
    top, half = q * RADIUS / (2 * material.transfer), LENGTH / 2 / decay
    # Two halves of equal length, insulated at the ends: half of `top` where they meet.
    cold = 0.5 * top * np.cosh(z / decay) / np.cosh(half)
    hot = top - 0.5 * top * np.cosh((LENGTH - z) / decay) / np.cosh(half)
    expected = np.where(z < LENGTH / 2, cold, hot)
    np.testing.assert_allclose(model.steady().mean(axis=0), expected, atol=2e-3 * top)


def test_a_thin_rope_cools_like_one_lump() -> None:
    """Small Biot number h R / k: exp(-2 h t / (c R)); backward Euler is of first order in time."""
    material = ThermalMaterial(500.0, 500.0, 700.0, 1800.0, 10.0, 15.0)
    model = cylinder(material, cells=(2, 2))
    rate = 2 * material.transfer / (material.capacity * RADIUS)
    duration = 1.0 / rate
    start = np.full((5, 5), 75.0)
    errors = []
    for steps in (50, 100):
        history = model.run(duration, steps, start)
        exact = 15.0 + 60.0 * np.exp(-rate * history.time)
        errors.append(np.abs(history.mean - exact).max())
        np.testing.assert_allclose(
            history.mean,
            15 + 60 * (1 + rate * duration / steps) ** -np.arange(steps + 1.0),
            rtol=2e-4,
        )
    assert errors[1] == pytest.approx(0.5 * errors[0], rel=0.05)


def test_energy_is_balanced_in_every_step() -> None:
    model = cylinder()
    density = np.random.default_rng(0).uniform(0, 1e-4, model.num_cells)
    model.set_source(density)
    history = model.run(300.0, 30)
    balance = history.stored - history.stored[0] + history.given_off - history.generated
    assert np.abs(balance).max() < 1e-10 * history.generated[-1]
    assert history.stored[-1] > 0.1 * history.generated[-1]  # nothing trivial is balanced
    assert history.given_off[-1] > 0.05 * history.generated[-1]


def test_after_a_long_time_the_state_is_steady() -> None:
    model = cylinder()
    model.set_source(np.random.default_rng(1).uniform(0, 1e-4, model.num_cells))
    history = model.run(1e6, 20)
    np.testing.assert_allclose(history.field, model.steady(), rtol=1e-8)
    assert history.maximum[-1] == pytest.approx(model.steady().max())
    assert (np.diff(history.maximum) > -1e-9).all() and history.maximum[0] == 20.0


def test_bad_input_is_named() -> None:
    model = cylinder(cells=(2, 2))
    with pytest.raises(ValueError, match="heat source: shape"):
        model.set_source(np.zeros((3, 3)))
    with pytest.raises(ValueError, match="0 steps"):
        model.run(1.0, 0)
    with pytest.raises(ValueError, match="radial edges of the cells"):
        RopeHeat(MPI.COMM_WORLD, np.array([0.0, 2.0, 1.0]), np.array([0.0, 1.0]), ROPE)
    with pytest.raises(ValueError, match="begin at -1"):
        RopeHeat(MPI.COMM_WORLD, np.array([-1.0, 2.0]), np.array([0.0, 1.0]), ROPE)
    with pytest.raises(ValueError, match="density: -1"):
        ThermalMaterial(1.0, 1.0, -1.0, 1.0, 1.0)


@started.needs_mpirun
def test_two_ranks_agree_with_one(tmp_path: Path) -> None:
    fields = []
    for ranks in (1, 2):
        path = tmp_path / f"{ranks}.npy"
        script = str(Path(__file__).with_name("parallel_heat.py"))
        done = started.run(sys.executable, script, path, ranks=ranks)
        assert done.returncode == 0, done.stderr
        fields.append(np.load(path))
    np.testing.assert_allclose(fields[0], fields[1], rtol=1e-12)
