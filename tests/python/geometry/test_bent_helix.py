"""Closed forms of the bent braid, against lengths of helices on a bent cylinder."""

import math

import numpy as np
import pytest

from braidx.geometry.bent_helix import bend_radius, frictionless_slip


def test_the_rope_of_paper_2():
    assert bend_radius(40.0, 12.0) == 26.0
    slip = frictionless_slip(4.0, math.radians(30.0), 26.0)
    assert slip == pytest.approx(2.0 * 16.0 * 0.75**1.5 / (26.0 * 0.5))


@pytest.mark.parametrize("degrees", [20.0, 30.0, 45.0])
def test_slip_evens_out_the_stretch_of_a_bent_helix(degrees):
    """Half a turn on the outer side is longer by twice the slip of one yarn; two yarns slip along the axis."""
    angle, radius, bend = math.radians(degrees), 4.0, 4e4
    turn = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 20001)
    along = radius / math.tan(angle)  # way along the axis per turn in radians
    rate = np.hypot(radius, along * (1.0 + radius / bend * np.cos(turn)))
    longer = np.trapezoid(rate - np.hypot(radius, along), turn)
    relative = 2.0 * (longer / 2.0) * math.cos(angle)
    assert frictionless_slip(radius, angle, bend) == pytest.approx(relative, rel=1e-3)
