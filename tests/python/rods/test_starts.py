"""Starts that are no equilibria: rods in each other, forces that nothing balances, loads as small as round-off."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, NotConverged, Rods, Solid, YarnMaterial, arc, straight
from braidx.rods.start import floats

SOFT = YarnMaterial.isotropic(1000.0, 0.3)
STEEL = YarnMaterial.isotropic(200e3, 0.3)


def crossed(height):
    """Two clamped beams of radius 1 across each other, whose centre lines are a height apart."""
    lines = [straight((-8, 0, 0), (8, 0, 0), 16), straight((0, -8, height), (0, 8, height), 16)]
    rods = Rods([Beam(line, 1.0, SOFT) for line in lines])
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    return rods


@pytest.mark.parametrize("height", [1.9, 1.1, 0.9, 0.1, -0.9])
def test_rods_placed_in_each_other_are_pushed_apart(height):
    rods = crossed(height)
    rods.solve()
    apart = rods.positions(1)[8, 2] - rods.positions(0)[8, 2]
    # Sections flatten where they touch, by up to 2 %.
    assert apart == pytest.approx(2.0 * np.sign(height), abs=0.05)
    assert rods.contacts()["gap"].min() > -0.01 * 1.01
    up, down = (rods.reactions(rod, [0, -1])[0].sum(axis=0)[2] for rod in (1, 0))
    assert up == pytest.approx(-down, rel=1e-6) and up * height < 0.0  # they push each other
    assert not rods.loads.at(1.0)[0].any()


def woven(overlap):
    """Two by two woven yarns of radius 1, their crossings too low by a share of the sum of radii."""
    pitch, yarns = 6.0, []
    for number in range(2):
        for along in range(2):
            at = np.linspace(0.0, 2.0 * pitch, 25)
            side = (-1) ** (number + along) * (1.0 - overlap)
            line = np.full((25, 3), (number + 0.5) * pitch)
            line[:, along], line[:, 2] = at, side * np.sin(np.pi * at / pitch)
            yarns.append(Beam(line, 1.0, SOFT))
    rods = Rods(yarns)
    for number in range(4):
        rods.clamp(number, [0, -1])
    return rods


@pytest.mark.parametrize("overlap", [0.02, 0.45])
def test_yarns_woven_in_each_other_are_pushed_apart(overlap):
    rods = woven(overlap)
    rods.solve(max_cuts=0)
    assert rods.contacts()["gap"].min() > -0.01 * 1.01
    for number, along in enumerate([1.0, -1.0, -1.0, 1.0]):
        height = along * rods.positions(number)[6, 2]
        assert height == pytest.approx(1.0, abs=0.1)  # soft sections flatten where they touch


def test_rods_with_one_centre_line_are_refused():
    rods = crossed(0.0)
    with pytest.raises(NotConverged, match="centre lines of rods 0 and 1 meet"):
        rods.solve()


SNAPS = pytest.mark.xfail(
    strict=True,
    raises=NotConverged,
    reason="loads that balance a ring at the start are dead, and let it snap while they go off",
)


@pytest.mark.parametrize("degrees", [180.0, pytest.param(350.0, marks=SNAPS)])
def test_a_bent_rod_that_would_be_straight_opens(degrees):
    line = arc(30.0, np.radians(degrees), 32)
    rods = Rods([Beam(line, 1.0, STEEL, natural_state="straight")])
    rods.clamp(0, 0)
    rods.solve(increments=8, max_cuts=0)
    end, length = rods.positions(0)[-1], 30.0 * np.radians(degrees)
    assert end == pytest.approx([length, 0.0, 0.0], abs=2e-3 * length)
    assert np.abs(rods.reaction(0, 0)[1]).max() < 1e-3


def test_a_released_end_is_let_go_little_by_little():
    rods = Rods([Beam(straight((0, 0, 0), (100, 0, 0), 16), 1.0, STEEL)])
    rods.clamp(0, 0)
    rods.hold(0, -1, [1, 3, 4, 5, 6, 7, 8])
    rods.move(0, -1, by=(0.0, 1.0, 0.0))
    rods.solve(1)
    rods.release(0, -1, 1)
    heights = []
    rods.solve(4, observe=lambda share: heights.append(rods.positions(0)[-1, 1]))
    assert np.diff([1.0, *heights]) == pytest.approx(-0.25, rel=0.01)
    assert heights[-1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("share", [1e-8, 1e-10, 1e-13, 1e-15, 1e-18])
def test_a_tiny_load_bends_as_linear_theory_says(share):
    """A cantilever under a load that is a share of EA."""
    rods = Rods([Beam(straight((0, 0, 0), (100, 0, 0), 16), 1.0, STEEL)])
    load = share * 200e3 * np.pi
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, load, 0.0))
    rods.solve()
    shear = 100.0 / (200e3 / 2.6 * np.pi)
    assert rods.positions(0)[-1, 1] / load == pytest.approx(
        100.0**3 / (3.0 * 200e3 * np.pi / 4.0) + shear, rel=1e-3
    )


def test_a_load_that_round_off_hides_is_refused():
    """Along a rod it would change positions of 100 mm by 1e-15 mm."""
    rods = Rods([Beam(straight((0, 0, 0), (100, 0, 0), 16), 1.0, STEEL)])
    rods.clamp(0, 0)
    rods.force(0, -1, (1e-17 * 200e3 * np.pi, 0.0, 0.0))
    with pytest.raises(NotConverged, match="lost in the round-off of internal forces"):
        rods.solve()


def test_a_failure_names_rods_that_nothing_holds():
    """A beam that is pulled away from a clamped one, and one that supports only let spin."""
    lines = [straight((0, 0, z), (20, 0, z), 8) for z in (0.0, 5.0, 10.0)]
    rods = Rods([Beam(line, 1.0, SOFT) for line in lines])
    rods.clamp(0, 0)
    rods.pin(2, [0, -1])
    rods.force(1, 0, (0.0, 0.0, 1.0))
    with pytest.raises(NotConverged, match="But for contact, rods 1, 2 float"):
        rods.solve(max_cuts=0)


def test_what_supports_leave_a_rod():
    arched = arc(10.0, 1.0, 8)
    rods = Rods(
        [Cable(arched, 0.5, 1e3, tension=1.0), Solid(straight((0, 0, 5), (9, 0, 5), 4), 1.0, SOFT)]
    )
    for nodes, left in (([0], True), ([0, -1], True), ([0, 4, -1], False)):
        rods.pin(0, nodes)
        assert floats(rods.layout, rods.supports, 0) is left
    for component in range(3):
        assert floats(rods.layout, rods.supports, 1)
        rods.hold_mean([(1, 0), (1, -1)], [component])
    assert floats(rods.layout, rods.supports, 1)
    rods.clamp(1, 0)
    assert not floats(rods.layout, rods.supports, 1)


@pytest.mark.parametrize("model", [Beam, Solid])
def test_left_handed_directors_are_refused(model):
    line = straight((0, 0, 0), (10, 0, 0), 4)
    directors = np.tile(np.eye(3)[[2, 1]], (5, 1, 1))
    with pytest.raises(
        ValueError, match="directors of rod 1 are left-handed at node 0: g1 x g2 must"
    ):
        Rods([Beam(line + 5.0, 1.0, SOFT), model(line, 1.0, SOFT, directors=directors)])
    with pytest.raises(ValueError, match=r"directors of rod 0 have shape \(4, 2, 3\)"):
        Rods([model(line, 1.0, SOFT, directors=directors[1:])])
