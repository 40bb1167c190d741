"""Scenes of rods that are given what is no number: refused at the door; what a computation makes of one ends it."""

import numpy as np
import pytest

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, straight

MATERIAL = YarnMaterial.isotropic(1e3, 0.3)
BAD = (0.0, np.nan, 0.0)


def two_beams():
    lines = straight((0, 0, 0), (12, 0, 0), 4), straight((6, -5, 2.0), (6, 7, 2.0), 4)
    rods = Rods([Beam(line, 1.0, MATERIAL) for line in lines])
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    return rods


GIVEN = {
    "force is .*nan": lambda rods: rods.force(0, 2, BAD),
    r"force has shape \(2,\): give \(3,\)": lambda rods: rods.force(0, 2, (0.0, 1.0)),
    "load is .*inf": lambda rods: rods.line_load(0, (np.inf, 0.0, 0.0)),
    "couple is .*nan": lambda rods: rods.couple(0, 2, BAD),
    "by is .*nan": lambda rods: rods.move(0, 0, by=BAD),
    "turn is .*nan": lambda rods: rods.move(0, 0, turn=BAD),
    "about is .*nan": lambda rods: rods.move(0, 0, turn=(0, 0, 1), about=BAD),
    "guess is .*nan": lambda rods: rods.solve(guess=np.full(rods.q.size, np.nan)),
    r"guess has shape \(3,\)": lambda rods: rods.solve(guess=np.zeros(3)),
    "guess of rod 1 is .*nan": lambda rods: rods.solve(guess={1: np.full((5, 3), np.nan)}),
    "centre line 0 is not finite": lambda rods: Beam(np.full((5, 3), np.nan), 1.0, MATERIAL),
}


@pytest.mark.parametrize("message", GIVEN)
def test_what_is_no_number_is_named(message):
    with pytest.raises(ValueError, match=message):
        made = GIVEN[message](two_beams())
        Rods([made])


def test_a_start_that_is_no_number_is_an_error():
    rods = two_beams()
    rods.q[40] = np.nan
    with pytest.raises(ValueError, match="unknown 40 of 90 is nan: contact needs finite positions"):
        rods.solve()


def test_a_residual_that_is_no_number_has_diverged():
    rods = two_beams()
    rods.contact.pairing.stiffness = np.nan
    with pytest.raises(NotConverged, match="no equilibrium"):
        rods.move(1, [0, -1], by=(0, 0, -0.1))
        rods.solve(max_cuts=1)


def test_loads_beyond_all_bounds_end_with_a_message():
    rods = two_beams()
    rods.force(0, 2, (0.0, 0.0, 1e200))
    with pytest.raises(NotConverged):
        rods.solve(max_cuts=1)
