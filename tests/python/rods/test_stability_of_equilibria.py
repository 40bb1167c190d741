"""Negative pivots of the tangent at equilibria whose stability is known."""

import logging

import numpy as np
import pytest

from braidx.rods import Beam, Rods, YarnMaterial

RADIUS, LENGTH, SPANS, POISSON = 1.0, 100.0, 20, 0.3
MATERIAL = YarnMaterial.isotropic(2e4, POISSON)
CRITICAL = (
    np.pi * RADIUS / (2.0 * LENGTH)
) ** 2  # strain of Euler's load of a column with hinges at both ends


def straight():
    line = np.zeros((2 * SPANS + 1, 3))
    line[:, 2] = np.linspace(0.0, LENGTH, len(line))
    return Rods([Beam(line, RADIUS, MATERIAL)])


@pytest.mark.parametrize(
    ("load", "modes"), [(0.9, 0), (1.1, 1), (3.8, 1), (4.3, 2), (8.5, 2), (9.8, 3)]
)
def test_a_column_is_unstable_in_two_planes_per_mode(load, modes, caplog, monkeypatch):
    """Buckling loads of a column with hinges are 1, 4, 9 times Euler's."""
    rods = straight()
    rods.pin(0, [0, -1])
    rods.hold(0, 0, [4])  # no spin
    rods.move(0, -1, by=(0.0, 0.0, -load * CRITICAL * LENGTH))
    monkeypatch.setattr(logging.getLogger("braidx"), "propagate", True)  # runs switch it off
    with caplog.at_level(logging.WARNING):
        rods.solve()
    assert np.abs(rods.positions(0)[:, :2]).max() < 1e-9  # it stays straight
    assert rods.negative_pivots == 2 * modes
    assert ("unstable equilibrium" in caplog.text) == (modes > 0)


def test_a_shaft_buckles_under_its_torque():
    """Clamped ends, one of them free to come nearer: M = 8.987 E I / L, a turn by 8.987 (1 + nu) radians."""
    rods, turn = straight(), 1.0
    rods.clamp(0, [0, -1])
    rods.release(0, -1, [2])
    found = []
    for _ in range(14):
        rods.move(0, -1, turn=(0.0, 0.0, turn))
        rods.solve()
        found.append(rods.negative_pivots)
    last_stable = int(8.987 * (1.0 + POISSON))
    assert found == [0] * last_stable + [2] * (14 - last_stable)
