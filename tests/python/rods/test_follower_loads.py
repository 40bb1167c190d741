"""Follower loads on rods against the elastica and statics of rings."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from braidx.rods import Beam, Cable, Rods, YarnMaterial, arc, ring, straight

RADIUS, LENGTH = 0.5, 100.0
STEEL = YarnMaterial.isotropic(200e3, 0.3)
BENDING = 200e3 * np.pi * RADIUS**4 / 4.0


def elastica(load):
    """End of an inextensible cantilever along x, clamped at the origin, under a force across its end section.

    Seen from the end section, the force keeps its direction: an initial value problem from there. With the arc length
    s from the end and the angle a of the tangent in that frame, EI da/ds = load times the way along the end's tangent.
    """

    def rates(_, y):
        x, _, angle = y
        return np.cos(angle), np.sin(angle), -load * x / BENDING

    y = solve_ivp(rates, (0.0, LENGTH), np.zeros(3), rtol=1e-10, atol=1e-12).y[:, -1]
    # The clamp is at y[:2] of this frame, which looks along the rod backwards: its tangent is turned to the x axis.
    turn = y[2]
    back = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    return back @ y[:2], turn


def cantilever(num_spans):
    rods = Rods([Beam(straight((0, 0, 0), (LENGTH, 0, 0), num_spans), RADIUS, STEEL)])
    rods.clamp(0, 0)
    rods.hold(0, slice(1, None), [2])
    return rods


def in_section(rods, force):
    """Components of a force along the last section's directors and normal at rest."""
    g1, g2 = rods.directors(0)[-1]
    return [force @ g1, force @ g2, force @ np.cross(g1, g2)]


def test_cantilever_under_a_force_that_turns_with_its_end():
    """The end turns by more than a right angle: P L^2 / EI = 4."""
    load = 4.0 * BENDING / LENGTH**2
    rods = cantilever(40)
    rods.follower_force(0, -1, in_section(rods, np.array([0.0, load, 0.0])))
    rods.solve(increments=5)
    end, turn = elastica(load)
    position, normal = rods.positions(0)[-1], np.cross(*rods.directors(0)[-1])
    assert position[:2] == pytest.approx(end, abs=1e-3 * LENGTH)
    assert np.arctan2(normal[1], normal[0]) == pytest.approx(-turn, abs=5e-3)
    force, moment = rods.reaction(0, 0)
    across = load * np.array([-normal[1], normal[0], 0.0])
    assert force == pytest.approx(-across, rel=1e-4, abs=1e-4 * load)
    assert moment == pytest.approx(-np.cross(position, across), rel=1e-4, abs=1e-4 * load)


def test_pressure_bends_a_cantilever_and_stays_normal_to_it():
    """Statics: the resultant is p times the chord, turned by a right angle."""
    load = 8.0 * BENDING / LENGTH**3
    rods = cantilever(16)
    rods.pressure(0, load)
    rods.solve(increments=4)
    end = rods.positions(0)[-1]
    assert end[1] > 0.3 * LENGTH
    force, moment = rods.reaction(0, 0)
    assert force == pytest.approx([load * end[1], -load * end[0], 0.0], rel=1e-5, abs=1e-8)
    # p times the integral of x . dx
    assert moment[2] == pytest.approx(-load * (end @ end) / 2.0, rel=1e-5)


def test_a_cable_under_pressure_is_a_circle():
    """Hoop tension p R (exact)."""
    line = arc(20.0, np.pi / 2, 16)
    cable = Cable(line, 0.1, 1e5)
    rods = Rods([cable])
    rods.pin(0, [0, -1])
    rods.hold(0, slice(1, -1), [2])
    load = 0.5
    rods.pressure(0, load, axis=(0, 0, -1))
    rods.solve(increments=2)
    # The hoop tension stretches the cable, and the circle through its ends gets smaller as it grows longer.
    tension = rods.tension(0)
    x = rods.positions(0)[:, :2]
    a, b, c = x[0], x[8], x[-1]
    sides = [np.linalg.norm(u - v) for u, v in ((a, b), (b, c), (c, a))]
    area = abs(np.cross(np.append(b - a, 0), np.append(c - a, 0))[2]) / 2.0
    radius = np.prod(sides) / (4.0 * area)
    assert tension == pytest.approx(load * radius * np.ones(8), rel=1e-3)


def pressed_ring(radius, load):
    """A ring under a pressure from inside, held from moving as a whole."""
    rods = Rods([Beam(ring(radius, 24), RADIUS, STEEL, closed=True)])
    rods.hold_mean([(0, node) for node in range(24)], [0])
    rods.hold(0, [0, 12], [1])
    rods.hold(0, slice(None), [2])
    rods.pressure(0, load, axis=(0, 0, -1))
    rods.solve()
    return rods


@pytest.mark.parametrize("share, unstable", [(0.95, 0), (1.05, 2)])
def test_a_ring_under_outer_pressure_buckles(share, unstable):
    """p = 3 EI / R^3 (Levy, 1884), by two modes, cos 2a and sin 2a: a turn makes up for what the held nodes take."""
    rods = pressed_ring(20.0, -share * 3.0 * BENDING / 20.0**3)
    assert rods.negative_pivots == unstable


def test_forces_that_follow_do_not_tell_of_stability():
    """A force across the end section has no potential; the cantilever under it is stable."""
    rods = cantilever(4)
    rods.follower_force(0, -1, in_section(rods, np.array([0.0, 4.0 * BENDING / LENGTH**2, 0.0])))
    rods.solve(increments=4)
    assert rods.negative_pivots == 0


def test_a_ring_under_inner_pressure():
    """N = p R, and R grows by N / EA."""
    radius, load = 20.0, 5.0
    rods = pressed_ring(radius, load)
    stiffness = 200e3 * np.pi * RADIUS**2
    assert rods.tension(0) == pytest.approx(load * radius * np.ones(12), rel=2e-3)
    grown = np.linalg.norm(rods.positions(0)[:-1, :2], axis=1).mean() - radius
    assert grown == pytest.approx(load * radius**2 / stiffness, rel=0.01)


def test_loads_at_once_and_loads_that_grow():
    """Two increments: one load is there from the first on, the other one grows."""
    rods = cantilever(4)
    rods.force(0, -1, (3e-3, 0.0, 0.0), at_once=True)
    rods.force(0, 2, (1e-3, 0.0, 0.0))
    held = []
    rods.solve(increments=2, observe=lambda share: held.append(rods.reaction(0, 0)[0][0]))
    assert held == pytest.approx([-3.5e-3, -4e-3], rel=1e-6)
    rods.force(0, -1, (0.0, 0.0, 0.0))
    rods.force(0, 2, (0.0, 0.0, 0.0), at_once=True)
    rods.solve(increments=2, observe=lambda share: held.append(rods.reaction(0, 0)[0][0]))
    assert held[2:] == pytest.approx([-1.5e-3, 0.0], rel=1e-6, abs=1e-9)


def test_bad_follower_loads_are_named():
    rods = Rods([Cable(straight((0, 0, 0), (9, 0, 0), 4), 0.1, 1e3)])
    with pytest.raises(ValueError, match="rod 0 is a cable: forces follow sections"):
        rods.follower_force(0, -1, (0, 0, 1))
    with pytest.raises(ValueError, match="axis is .*: give a direction"):
        rods.pressure(0, 1.0, axis=(0, 0, 0))
    with pytest.raises(ValueError, match="load is nan: give finite numbers"):
        rods.pressure(0, np.nan)
    with pytest.raises(IndexError, match="rod 1: there are rods 0 to 0"):
        rods.pressure(1, 1.0)
