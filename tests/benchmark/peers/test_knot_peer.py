"""The peer's knot at its smallest, so that it never rots. No time is judged here."""

import numpy as np
import pytest
from knot import (
    LENGTH,
    LOOSE,
    PEER,
    RADIUS,
    Outcome,
    asymptotic_force,
    draw,
    end_distance,
    loop_radius,
    loose_line,
    overhand_knot,
    tighten,
)


def test_the_start_is_a_knot_of_the_right_length():
    line = loose_line(LOOSE, RADIUS, LENGTH, 240)
    chords = np.linalg.norm(np.diff(line, axis=0), axis=1)
    assert chords.sum() == pytest.approx(LENGTH, rel=1e-4)
    assert chords.max() < 1.1 * chords.min()
    assert np.linalg.norm(line[-1] - line[0]) == pytest.approx(LOOSE)
    # Its strands turn about each other by three half turns, as those of a trefoil.
    x = np.linspace(-45.0, 45.0, 200)
    halves = line[:120], line[121:]
    halves = [half[half[:, 1] < 10.0 * RADIUS] for half in halves]
    halves = [half[np.argsort(half[:, 0])] for half in halves]
    y, z = (
        np.interp(x, *halves[1][:, [0, i]].T) - np.interp(x, *halves[0][:, [0, i]].T)
        for i in (1, 2)
    )
    turn = np.unwrap(np.arctan2(z, y))
    assert abs(turn[-1] - turn[0]) == pytest.approx(3.0 * np.pi, rel=0.1)


def test_smallest_knot():
    """Nothing pulls sideways, the first force is that of theory for loose knots, and with friction it is the peer's."""
    knot = overhand_knot(num_spans=160)
    assert end_distance(knot) == pytest.approx(LOOSE)
    force = knot.reaction(0, -1)[0]
    assert np.abs(force[1:]).max() < 0.1 * force[0]
    loose = asymptotic_force(LOOSE, 0.0)
    assert loose < force[0] < 1.3 * loose
    outcome = tighten(knot, 310.0, 5)
    assert end_distance(knot) == pytest.approx(310.0)
    smooth = np.polyval(np.polyfit(PEER[:, 0], PEER[:, 1], 2), 310.0)
    assert outcome.force(310.0) == pytest.approx(smooth, rel=0.1)
    ends = [knot.reaction(0, node)[0] for node in (0, -1)]
    assert np.linalg.norm(ends[0] + ends[1]) < 1e-3 * np.linalg.norm(ends[1])
    assert knot.friction_work > 0.0


def test_picture(tmp_path):
    distance = np.array([300.0, 400.0, 520.0])
    curve = np.stack([distance, asymptotic_force(distance, 0.3)], axis=1)
    cheap = Outcome(curve, 1000, 3, 30, 10, 2.0, 200.0)
    assert draw([cheap, cheap], tmp_path / "knot.png").stat().st_size > 10_000
    assert cheap.force(400.0) == curve[1, 1]
    assert loop_radius(LENGTH - 2.0 * np.pi) == pytest.approx(1.0)
