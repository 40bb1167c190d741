"""Sharpest bends: of circles and helices, where they are known."""

import numpy as np
import pytest

from braidx.geometry.curves import arc, helix, straight
from braidx.processes.sharp_bends import sharpest_bend


def test_sharpest_bend_is_that_of_the_yarn_whose_radius_it_is_least_of():
    lines = [arc(3.0, 2.0, 40), arc(5.0, 2.0, 40), straight((0, 0, 0), (9, 0, 0), 7)]
    assert sharpest_bend(lines, np.array([1.0, 1.0, 1.0])) == (pytest.approx(3.0), 0)
    assert sharpest_bend(lines, np.array([1.0, 2.5, 1.0])) == (pytest.approx(2.0), 1)


def test_straight_yarns_have_none():
    assert sharpest_bend([straight((0, 0, 0), (0, 0, 5), 9)], np.ones(1))[0] > 1e6


def test_a_helix():
    radius, pitch = 2.0, 9.0
    rise = pitch / (2.0 * np.pi)
    ratio, yarn = sharpest_bend([helix(radius, pitch, pitch, 200)], np.array([0.5]))
    assert ratio == pytest.approx((radius**2 + rise**2) / radius / 0.5, rel=1e-3)
    assert yarn == 0
