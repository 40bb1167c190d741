"""The twisted yarn at its smallest, so that it never rots. No time is judged here."""

import numpy as np
import pytest
from twisted_yarn import (
    LENGTH,
    RADIUS,
    STIFFNESS,
    TENSION,
    draw,
    helices,
    hexagonal,
    spun,
    twist,
    yarn,
)


def test_places_touch_and_do_not_overlap():
    places = hexagonal(19)
    apart = np.linalg.norm(places[:, None] - places, axis=2) + 9.0 * np.eye(19)
    assert apart.min() == pytest.approx(1.0)
    assert np.sort(np.linalg.norm(places, axis=1))[[6, -1]] == pytest.approx([1.0, 2.0])


def test_what_turns_back_is_straight():
    line = np.linspace([1.0, 0.5, 0.0], [1.0, 0.5, LENGTH], 9)
    assert spun(spun(line, 3.0), -3.0) == pytest.approx(line)


def test_untwisted_fibres_pull_by_their_tension():
    tension, torque = helices(0.0, np.full(7, RADIUS))
    assert (tension, torque) == pytest.approx((7.0 * TENSION, 0.0))


def test_a_fibre_off_the_axis():
    rate = 2.0 * np.pi / LENGTH
    tension, torque = helices(1.0, np.array([1.0]))
    assert tension == pytest.approx(TENSION + 0.5 * STIFFNESS * rate**2)
    assert torque == pytest.approx(tension * rate)


def test_smallest_yarn(tmp_path):
    """Forces are those of helices, but for the ends."""
    outcome = twist(yarn(7, 20), 1.0, 4)
    assert outcome.curve[-1, 1:] == pytest.approx(np.array(helices(1.0, outcome.radii)), rel=0.1)
    assert draw([outcome], tmp_path / "yarn.png").stat().st_size > 10_000
