"""Closed forms of biaxial braids."""

import math

import pytest

from braidx.geometry.closed_forms import (
    braid_pitch,
    cover_factor,
    helix_angle,
    jamming_angle,
    strand_share,
)


@pytest.mark.parametrize(("degrees", "cover"), [(30, 0.6876), (45, 0.7886), (60, 0.9443)])
def test_cover_factor(degrees, cover):
    assert cover_factor(12, 2.0, 5.0, math.radians(degrees)) == pytest.approx(cover, abs=5e-5)


def test_jamming_angle():
    jammed = jamming_angle(12, 2.0, 4.0)
    assert jammed is not None and math.degrees(jammed) == pytest.approx(61.48, abs=5e-3)
    assert jamming_angle(12, 2.0, 1.0) is None


def test_neighbours_touch_at_the_jamming_angle():
    jammed = jamming_angle(12, 2.0, 4.0)
    assert jammed is not None
    assert strand_share(6, 4.0, braid_pitch(4.0, jammed)) == pytest.approx(2.0)


def test_helix_angle_and_pitch_are_inverse():
    angle = helix_angle(7.0, 132.0)
    assert math.degrees(angle) == pytest.approx(18.43, abs=5e-3)
    assert braid_pitch(7.0, angle) == pytest.approx(132.0)
