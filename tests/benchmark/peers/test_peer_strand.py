"""The strand of the benchmark at its smallest: wires stick, then slip, and friction shows when they are bent back."""

import numpy as np
import pytest
from strand import FRICTION, LENGTH, TENSION, draw, layer_radius, num_layers, row, run


def test_layers_are_full():
    assert [num_layers(wires) for wires in (7, 19, 37, 61, 91)] == [1, 2, 3, 4, 5]
    with pytest.raises(ValueError, match="20 wires"):
        num_layers(20)


def test_seven_wires_stick_and_slip(tmp_path):
    outcome = run(7, angle=0.1, step=0.05, back=True)
    moments, top = outcome.moments, int(np.argmax(outcome.angles))
    assert outcome.angles[top] == pytest.approx(0.1) and outcome.angles[-1] == pytest.approx(0.0)
    bent = slice(1, top + 1)
    assert np.all(moments[bent] > outcome.slipping[bent])
    assert np.all(moments[bent] < outcome.sticking[bent])
    slopes = np.diff(moments) / np.diff(outcome.angles)
    assert slopes[0] > 1.5 * slopes[top - 1]  # wires stick at first
    assert slopes[top] > 1.5 * slopes[top - 1]  # and when they are bent back
    # Friction of wires that are all pressed onto the king wire by their tension, and slip along it from the free end
    # on: those on one side one way, those on the other the other.
    radius = layer_radius(1)
    slope = 2.0 * np.pi * radius / LENGTH
    pressure = TENSION * slope**2 / (1.0 + slope**2) / radius
    friction = FRICTION * pressure * LENGTH * radius * 6 * 2.0 / np.pi
    assert moments[-1] == pytest.approx(-friction, rel=0.5)
    assert f"| {outcome.unknowns} |" in row(outcome)
    draw([outcome], tmp_path / "strand.png")
    assert (tmp_path / "strand.png").stat().st_size > 1000
