"""Cables that are placed with little tension or none: the catenary, and cables that are pulled taut.

A cable of length L, tension T and stiffness EA between two pins, under the load w per length, sags to a parabola whose
horizontal force follows from its length: H^3 - T H^2 = EA w^2 L^2 / 24.
"""

import numpy as np
import pytest
from scipy.optimize import brentq

from braidx.rods import Cable, Rods, straight

STIFFNESS, LENGTH, LOAD = 1e5, 1000.0, 0.01  # N, mm, N/mm


def cable(degree, tension=0.0, shares=None):
    """Along x, of 40 spans; `shares` of its length are where nodes are, if not evenly."""
    line = straight((0, 0, 0), (LENGTH, 0, 0), 40)
    if shares is not None:
        line[:, 0] = LENGTH * shares
    return Rods([Cable(line, 1.0, STIFFNESS, tension=tension, degree=degree)])


def iterations(increments):
    """Newton iterations of all increments, none of which had to be cut."""
    assert len(increments) == 1
    return sum(increment.iterations for increment in increments)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize(
    "tension, force", [(0.0, 74.69), (1e-6, 74.69), (1.0, 75.02), (50.0, 95.60)]
)
def test_catenary(tension, force, degree):
    def cubic(h):
        return h**3 - tension * h**2 - STIFFNESS * (LOAD * LENGTH) ** 2 / 24.0

    assert brentq(cubic, 1.0, 1e3) == pytest.approx(force, abs=0.01)
    rods = cable(degree, tension)
    rods.pin(0, [0, -1])
    rods.line_load(0, (0, 0, -LOAD))
    assert iterations(rods.solve()) <= 20
    assert -rods.reaction(0, 0)[0][0] == pytest.approx(brentq(cubic, 1.0, 1e3), rel=1e-3)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("across", [True, False], ids=["held across", "free across"])
def test_a_cable_without_tension_is_pulled_taut(across, degree):
    rods = cable(degree, shares=np.linspace(0.0, 1.0, 41) ** 1.5)
    rods.pin(0, [0, -1])
    if across:
        rods.hold(0, slice(None), [1, 2])
    rods.move(0, -1, by=(1.0, 0, 0))
    assert iterations(rods.solve()) <= 3
    assert rods.tension(0) == pytest.approx(STIFFNESS * 1.0 / LENGTH, rel=1e-7)


@pytest.mark.parametrize("degree", [1, 2])
def test_a_cable_is_pushed_slack_and_pulled_taut_again(degree):
    rods = cable(degree)
    rods.pin(0, [0, -1])
    rods.hold(0, slice(None), [1, 2])
    rods.move(0, -1, by=(-10.0, 0, 0))
    iterations(rods.solve())
    assert not rods.tension(0).any() and not rods.reaction(0, -1)[0].any()
    rods.move(0, -1, by=(20.0, 0, 0))
    assert iterations(rods.solve()) <= 10
    assert rods.tension(0) == pytest.approx(STIFFNESS * 10.0 / LENGTH, rel=1e-7)


def test_a_force_on_a_cable_without_tension_makes_it_sag():
    """P in the middle: two straight halves, P = 2 T sin(a), T = EA (1 / cos(a) - 1)."""
    force = 1.0
    rods = cable(1)
    rods.pin(0, [0, -1])
    rods.force(0, 20, (0, -force, 0))
    assert iterations(rods.solve()) <= 20
    angle = brentq(lambda a: 2 * STIFFNESS * (1 / np.cos(a) - 1) * np.sin(a) - force, 1e-6, 0.5)
    assert rods.tension(0) == pytest.approx(STIFFNESS * (1 / np.cos(angle) - 1), rel=1e-7)
