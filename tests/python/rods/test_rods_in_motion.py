"""Rods that fly, fall and swing."""

import numpy as np
import pytest
from scipy.special import ellipk

from braidx.rods import Beam, Cable, Rods, Scheme, Solid, YarnMaterial, straight

DENSITY = 1e-6  # t/mm^3
LINE = straight((0, 0, 0), (10, 0, 0), 4)
CABLE = Cable(LINE, 0.5, 1e3, density=DENSITY)
BEAM = Beam(LINE, 0.5, YarnMaterial.isotropic(1e3, 0.3), density=DENSITY)


@pytest.mark.parametrize("rod", [CABLE, BEAM], ids=["cable", "beam"])
def test_free_flight(rod):
    rods = Rods([rod], tolerance=1e-12)
    velocity = np.zeros(rods.q.size)
    nodes = velocity.reshape(len(LINE), -1)
    nodes[:, :3] = [3.0, -2.0, 5.0]
    rods.run(0.5, 0.1, velocity=velocity)
    assert rods.positions(0) == pytest.approx(LINE + [1.5, -1.0, 2.5], abs=1e-10)
    assert rods.time == pytest.approx(0.5)
    mass = DENSITY * np.pi * 0.5**2 * 10.0
    assert rods.kinetic_energy() == pytest.approx(0.5 * mass * 38.0, rel=1e-10)
    rods.run(0.1, 0.1)  # goes on with the velocity that it has
    assert rods.positions(0) == pytest.approx(LINE + [1.8, -1.2, 3.0], abs=1e-10)


def test_fall_of_what_is_let_go():
    rods = Rods([CABLE], tolerance=1e-12)
    rods.pin(0, slice(None))
    rods.line_load(0, (0.0, 0.0, -DENSITY * np.pi * 0.5**2 * 9810.0))
    rods.solve()
    rods.release(0, slice(None))
    rods.run(0.02, 0.005)
    assert rods.positions(0) == pytest.approx(LINE - [0, 0, 0.5 * 9810.0 * 0.02**2], rel=1e-9)


@pytest.mark.parametrize("kind", [Beam, Solid])
def test_a_grain_falls_far(kind):
    """By 2,000 times its size: round-off of positions is then the largest internal force, and no reason to fail."""
    size, degree = 1e-3, {} if kind is Beam else {"degree": 1}
    line, material = size * straight((0, 0, 0), (4, 0, 0), 2), YarnMaterial.isotropic(1e3, 0.3)
    rods = Rods([kind(line, size, material, density=1e-9, **degree)])
    weight = 9810.0 * rods.layout.mass[~rods.layout.is_director].sum() / 3.0
    rods.line_load(0, (0.0, 0.0, -weight / (4.0 * size)))
    rods.loads.finish(1.0)  # from the start on
    rods.run(0.02, 0.005)
    fallen = 0.5 * 9810.0 * 0.02**2
    # Round-off is 1 % of the weight; its forces within the rod cancel.
    assert line - rods.positions(0) == pytest.approx(
        line * 0.0 + [0.0, 0.0, fallen], abs=1e-3 * fallen
    )


def test_a_pendulum_is_of_second_order():
    """From the horizontal it takes K(1/2) (L / g)^(1/2) to the lowest point, and is at (2 g L)^(1/2) there."""

    def lowest(steps):
        rods = Rods([Cable(straight((0, 0, 0), (100, 0, 0), 1), 1.0, 1e5, density=1e-9, degree=1)])
        rods.pin(0, 0)
        rods.hold(0, components=[1])
        mass = 1e-9 * np.pi * 50.0
        rods.force(0, -1, (0.0, 0.0, -9810.0 * mass))
        rods.loads.finish(1.0)  # from the start on
        duration = ellipk(0.5) * np.sqrt(100.0 / 9810.0)
        rods.run(duration, duration / steps)
        speed = np.sqrt(2.0 * rods.kinetic_energy() / mass / (2.0 * 9810.0 * 100.0))
        return abs(rods.positions(0)[-1, 0]) / 100.0, 1.0 - speed

    coarse, fine = np.array([lowest(20), lowest(40)])
    assert fine == pytest.approx([0.008, 0.006], rel=0.1)  # of the length, and of the speed
    assert np.log2(coarse / fine) == pytest.approx([2.0, 2.0], abs=0.25)


PERIOD = 2.0 * 10.0 / np.sqrt(1e3 / (DENSITY * np.pi * 0.5**2))  # of the slowest swing along it, s


def plucked():
    """A taut cable between its ends, its middle let go from 0.05 mm beside along the axis."""
    rods = Rods([Cable(LINE, 0.5, 1e3, tension=50.0, density=DENSITY)], tolerance=1e-11)
    rods.hold(0, components=[1, 2])
    rods.pin(0, [0, 2, -1])
    rods.solve()
    at_rest = rods.elastic_energy()
    rods.move(0, 2, by=(0.05, 0.0, 0.0))
    rods.solve()
    rods.release(0, 2, [0])
    return rods, at_rest


def swing(scheme):
    """Energy above that at rest after each of 50 steps of a period, over the first."""
    rods, at_rest = plucked()
    before, energies = rods.elastic_energy() - at_rest, []

    def observe(share):
        energies.append(rods.elastic_energy() + rods.kinetic_energy() - at_rest)

    rods.run(PERIOD, PERIOD / 50.0, scheme=scheme, observe=observe)
    assert len(energies) == 50
    return np.array(energies) / before


def test_an_oscillation_keeps_its_energy():
    """Stretches are small, so that it is nearly linear."""
    assert swing(Scheme.generalised_alpha(1.0)) == pytest.approx(np.ones(50), abs=5e-3)
    assert swing(Scheme.backward_euler())[-1] < 0.9


def test_motion_needs_density():
    rods = Rods([CABLE, Cable(LINE + [0, 9, 0], 0.5, 1e3)])
    with pytest.raises(ValueError, match="density of rod 1 is 0.0"):
        rods.run(1.0, 0.1)
