"""The balance of energy of rods in motion: what it says, and that no step makes energy."""

from functools import cache

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, Cable, NotConverged, Rods, Scheme, Solid, YarnMaterial, straight

SOFT = YarnMaterial.isotropic(1000.0, 0.3)
DENSITY = 1e-9  # t/mm^3
MADE = 1e-4  # root of the solver's tolerance: what steps may make of the energy in motion
RADIUS_1 = Scheme.generalised_alpha(1.0)
RADIUS_08 = Scheme.generalised_alpha(0.8)


def falling(scheme, steps=4, duration=0.02):
    """A cable in free fall from rest, its weight there from the start; its mass in t."""
    mass = 1e-6 * np.pi * 0.5**2 * 10.0
    rods = Rods([Cable(straight((0, 0, 0), (10, 0, 0), 4), 0.5, 1e3, density=1e-6)])
    rods.pin(0, slice(None))
    rods.line_load(0, (0.0, 0.0, -mass / 10.0 * 9810.0))
    rods.solve()
    rods.release(0, slice(None))
    rods.run(duration, duration / steps, scheme=scheme)
    return rods, mass


def test_backward_euler_takes_half_the_square_of_every_change_of_velocity():
    rods, mass = falling(Scheme.backward_euler())
    change = 9810.0 * 0.005
    for n, step in enumerate(rods.motion, start=1):
        assert step.numerical_dissipation == pytest.approx(0.5 * mass * change**2, rel=1e-8)
        assert step.kinetic == pytest.approx(0.5 * mass * (n * change) ** 2, rel=1e-8)
        assert step.work_of_loads == pytest.approx(mass * 9810.0 * n * change * 0.005, rel=1e-8)
        assert step.work_of_supports == step.friction_work == step.contact == 0.0
    assert [step.share for step in rods.motion] == pytest.approx([0.25, 0.5, 0.75, 1.0])


@pytest.mark.parametrize("scheme", [None, RADIUS_08])
def test_a_fall_loses_nothing(scheme):
    rods, mass = falling(scheme)
    fallen = 0.5 * 9810.0 * 0.02**2
    assert sum(step.work_of_loads for step in rods.motion) == pytest.approx(mass * 9810.0 * fallen)
    assert rods.motion[-1].kinetic == pytest.approx(mass * 9810.0 * fallen)
    assert [s.numerical_dissipation for s in rods.motion] == pytest.approx(np.zeros(4), abs=1e-9)


@pytest.mark.parametrize("scheme", [None, RADIUS_08])
def test_supports_drive_masses_and_catch_them(scheme):
    """All nodes move at one velocity, then stand: kinetic energy comes from supports and goes there."""
    rods = Rods([Cable(straight((0, 0, 0), (10, 0, 0), 4), 0.5, 1e3, density=1e-6)])
    rods.pin(0, slice(None))
    rods.move(0, slice(None), by=(0.0, 6.0, 0.0))
    rods.run(0.02, 0.005, scheme=scheme)
    kinetic = 0.5 * 1e-6 * np.pi * 0.5**2 * 10.0 * 300.0**2
    assert rods.kinetic_energy() == pytest.approx(kinetic, rel=1e-10)
    rods.run(0.005, 0.005, scheme=scheme)
    works = [step.work_of_supports for step in rods.motion]
    assert works == pytest.approx([kinetic, 0.0, 0.0, 0.0, -kinetic], abs=1e-9)
    assert rods.kinetic_energy() == 0.0


def test_a_pulled_end_does_the_work_that_is_stored():
    """Slowly, so that nearly all of it is: T e L + E A e^2 L / 2 of a bar under a tension T at rest."""
    line = straight((0, 0, 0), (10, 0, 0), 4)
    rods = Rods([Cable(line, 0.5, 1e3, tension=50.0, density=1e-9)])
    rods.hold(0, components=[1, 2])
    rods.pin(0, [0, -1])
    rods.move(0, -1, by=(0.05, 0.0, 0.0))
    before = rods.elastic_energy()
    rods.run(1.0, 0.1)
    stored = 50.0 * 0.05 + 0.5 * 1e3 * 0.005**2 * 10.0
    assert rods.motion[-1].elastic == rods.elastic_energy()
    assert rods.motion[-1].elastic - before == pytest.approx(stored, rel=1e-3)
    assert sum(step.work_of_supports for step in rods.motion) == pytest.approx(stored, rel=1e-3)


@cache
def collision(scheme, step):
    """Two free beams that cross; one falls on the other without friction. Energy before, mJ."""
    a, up = np.array([10.0, 0, 0]), np.array([5.0, 0, 2.2])
    d = 10.0 * np.array([1, 1, 0]) / 2**0.5
    lines = [straight(-a, a, 8), straight(up - d, up + d, 8)]
    rods = Rods([Beam(line, 1.0, SOFT, density=DENSITY) for line in lines])
    velocity = np.zeros(rods.q.size)
    velocity[rods.layout.unknowns(1, slice(None))[:, 2]] = -500.0
    rods.run(2e-3, step, velocity=velocity, scheme=scheme)
    return rods, 0.5 * DENSITY * np.pi * 20.0 * 500.0**2


@pytest.mark.parametrize("scheme, step", [(None, 1e-4), (None, 2e-4), (RADIUS_08, 1e-4)])
def test_a_collision_makes_no_energy(scheme, step):
    rods, before = collision(scheme, step)
    energies = np.array([step.energy for step in rods.motion])
    assert energies.max() <= before * (1.0 + MADE)
    assert rods.motion[-1].kinetic == rods.kinetic_energy()
    assert rods.motion[-1].elastic == pytest.approx(rods.elastic_energy(), rel=1e-12)
    lost = sum(step.numerical_dissipation for step in rods.motion)
    assert energies[-1] + lost == pytest.approx(before, rel=1e-10)
    assert max(step.contact for step in rods.motion) > 0.0


def test_a_step_that_makes_energy_is_halved_and_steps_grow_again():
    rods, _ = collision(RADIUS_08, 1e-4)
    lengths = [step.length for step in rods.motion]
    assert min(lengths) < 0.6e-4 and lengths[-1] == pytest.approx(1e-4)
    assert rods.time == pytest.approx(2e-3)


def test_a_scheme_that_makes_energy_is_refused():
    """Newmark's with gamma below a half: all oscillations grow."""
    growing = Scheme(0.0, 0.0, 0.25, 0.2)
    rods = Rods([Beam(straight((0, 0, 0), (10, 0, 0), 4), 0.5, SOFT, density=DENSITY)])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.5, 0.0))
    rods.solve()
    rods.force(0, -1, (0.0, 0.0, 0.0))
    rods.loads.finish(1.0)  # let go at once
    before = rods.elastic_energy()
    with pytest.raises(NotConverged, match=r"no step that keeps energy at .* made .* mJ out of .*"):
        rods.run(5e-3, 1e-4, scheme=growing, max_cuts=2)
    assert rods.elastic_energy() + rods.kinetic_energy() <= before * (1.0 + MADE)


def test_a_bent_rod_that_is_let_go_out_of_balance():
    """At rest a quarter of a circle would be straight: it opens, and swings with no more than it has."""
    turn = np.linspace(0.0, np.pi / 2, 11)
    line = 20.0 * np.column_stack([np.sin(turn), 0.0 * turn, 1.0 - np.cos(turn)])
    rods = Rods([Beam(line, 1.0, SOFT, density=DENSITY, natural_state="straight")])
    rods.clamp(0, 0)
    before = rods.elastic_energy()
    rods.run(2e-3, 1e-4)
    assert before == pytest.approx(0.5 * 1000.0 * np.pi / 4 * (np.pi / 2) / 20.0, rel=0.01)
    assert max(step.energy for step in rods.motion) <= before * (1.0 + MADE)
    assert rods.positions(0)[-1, 0] > 23.0


def test_dissipation_of_slow_motion_is_of_third_order():
    """Energy lost in a period by a taut cable that swings along its line."""

    def lost(steps):
        line, period = straight((0, 0, 0), (10, 0, 0), 2), 1e-3
        stiffness = 2.0 * 1e3 / 5.0
        mass = stiffness * (period / (2.0 * np.pi)) ** 2
        density = mass / (np.pi * 0.5**2 * 5.0)
        rods = Rods([Cable(line, 0.5, 1e3, tension=50.0, density=density, degree=1)])
        rods.pin(0, [0, 1, 2])
        at_rest = rods.elastic_energy()
        rods.move(0, 1, by=(0.01, 0.0, 0.0))
        rods.solve()
        rods.release(0, 1, [0])
        before = rods.elastic_energy() - at_rest
        rods.run(period, period / steps)
        return 1.0 - (rods.motion[-1].energy - at_rest) / before

    coarse, fine = lost(40), lost(80)
    assert fine < 0.01
    assert np.log2(coarse / fine) == pytest.approx(3.0, abs=0.3)


@pytest.mark.parametrize("size", [1.0, 0.001])
@pytest.mark.parametrize("kind, step", [(Beam, 2.5e-4), (Solid, 5e-4)])
def test_a_slope_of_friction(kind, step, size):
    """g (sin - mu cos) of 30 degrees and mu = 0.3, once its reversible slip is over, at any size."""
    down, up = np.array([3**0.5, 0.0, -1.0]) / 2.0, np.array([1.0, 0.0, 3**0.5]) / 2.0
    line = size * straight(up - 2.0 * down, up + 2.0 * down, 2 if kind is Solid else 4)
    rod = kind(line, size, SOFT, density=DENSITY, **({"degree": 1} if kind is Solid else {}))
    rods = Rods([rod], friction=0.3, rigid=[engine.make_plane(np.zeros(3), up, 0)])
    weight = 9810.0 * rods.layout.mass[~rods.layout.is_director].sum() / 3.0
    rods.line_load(0, (0.0, 0.0, -weight / (4.0 * size)))
    rods.loads.finish(1.0)  # from the start on
    way, times = [], []

    def see(step):
        way.append((rods.positions(0).mean(axis=0) - line.mean(axis=0)) @ down)
        times.append(step.time)

    rods.run(20 * step, step, observe=see)
    velocity = np.diff(way[-3:]) / np.diff(times[-3:])
    acceleration = np.diff(velocity)[0] / (0.5 * (times[-1] - times[-3]))
    assert acceleration == pytest.approx(9810.0 * (0.5 - 0.3 * 3**0.5 / 2.0), rel=1e-3)


@pytest.mark.parametrize("modulus", [10.0, 1000.0])
def test_a_block_that_slides_and_hits(modulus):
    """It hits a plane with friction on the whole of its side, soft and stiff, and flies off with what is left."""
    line = straight((-1.0, 0.0, 1.05), (1.0, 0.0, 1.05), 2)
    material = YarnMaterial.isotropic(modulus, 0.3)
    plane = engine.make_plane(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0)
    rods = Rods(
        [Solid(line, 1.0, material, density=DENSITY, degree=1)], friction=0.3, rigid=[plane]
    )
    velocity = np.where(rods.layout.is_director, 0.0, 1.0)
    velocity = (velocity.reshape(-1, 3) * [500.0, 0.0, -2000.0]).ravel()
    before = 0.5 * rods.layout.mass @ velocity**2
    rods.run(2e-3, 1e-4, velocity=velocity)
    assert max(step.energy for step in rods.motion) <= before * (1.0 + MADE)
    assert rods.positions(0)[:, 2].mean() > 1.05
    assert 0.0 < sum(step.friction_work for step in rods.motion) < 0.5 * before
