"""Joints between rods against beam theory: Gerber beam, portal frame, brackets, cables that meet."""

import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, Solid, YarnMaterial, straight

RADIUS, MODULUS = 0.5, 200e3
STEEL = YarnMaterial.isotropic(MODULUS, 0.3)
BENDING = MODULUS * np.pi * RADIUS**4 / 4.0


def beam(begin, end, num_spans=8):
    return Beam(straight(begin, end, num_spans), RADIUS, STEEL)


def test_gerber_beam():
    """Clamped over a, hinged to a span b on a roller, under q: the hinge carries q b / 2, whatever bends."""
    a, b, load = 60.0, 40.0, 1e-4
    rods = Rods([beam((0, 0, 0), (a, 0, 0)), beam((a, 0, 0), (a + b, 0, 0))])
    rods.clamp(0, 0)
    rods.hinge((1, 0), (0, -1))
    rods.hold(1, -1, [1, 2])
    rods.hold(1, 0, [5, 8])  # the second beam does not spin
    for rod in (0, 1):
        rods.line_load(rod, (0.0, -load, 0.0))
    rods.solve()
    force, moment = rods.reaction(0, 0)
    shear = load * b / 2.0
    assert force[1] == pytest.approx(load * a + shear, rel=1e-6)
    assert moment[2] == pytest.approx(load * a**2 / 2.0 + shear * a, rel=1e-4)
    assert rods.reaction(1, -1)[0][1] == pytest.approx(shear, rel=1e-5)
    sag = load * a**4 / 8.0 / BENDING + shear * a**3 / 3.0 / BENDING
    assert rods.positions(0)[-1] == pytest.approx(rods.positions(1)[0])
    assert -rods.positions(0)[-1, 1] == pytest.approx(sag, rel=1e-3)


def test_portal_frame():
    """Columns h, beam l, pushed at a corner by H: base moments H h / 2 (3 k + 1) / (6 k + 1), k = h / l, I alike."""
    h, span, push = 100.0, 150.0, 1e-3
    corners = [(0, 0, 0), (0, h, 0), (span, h, 0), (span, 0, 0)]
    rods = Rods([beam(*ends) for ends in zip(corners[:-1], corners[1:], strict=True)])
    for rod, node in ((0, 0), (2, -1)):
        rods.clamp(rod, node)
    rods.tie((0, -1), (1, 0))
    rods.tie((2, 0), (1, -1))
    rods.force(1, 0, (push, 0.0, 0.0))
    rods.solve()
    k = h / span
    base = push * h / 2.0 * (3 * k + 1) / (6 * k + 1)
    for rod, node in ((0, 0), (2, -1)):
        force, moment = rods.reaction(rod, node)
        assert moment[2] == pytest.approx(base, rel=2e-3)
        assert force[0] == pytest.approx(-push / 2.0, rel=2e-3)
    sway = push * h**3 / (12.0 * BENDING) * (3 * k + 2) / (6 * k + 1)
    assert rods.positions(1)[0, 0] == pytest.approx(sway, rel=2e-3)


@pytest.mark.parametrize("degree", [1, 2])
def test_hinge_within_an_element(degree):
    """A rod that hangs between two nodes of a clamped one pulls there: the clamp holds F at that arm."""
    line = straight((0, 0, 0), (40, 0, 0), 8)
    at = 5.3
    place = line[0] + at * 5.0 * np.array([1.0, 0, 0])
    hanging = Cable(straight(place, place - [0, 30, 0], 2), 0.1, 1e4)
    rods = Rods([Beam(line, RADIUS, STEEL, degree=degree), hanging])
    rods.clamp(0, 0)
    rods.hinge((1, 0), (0, at))
    rods.force(1, -1, (0.0, -0.01, 0.0))
    rods.solve()
    force, moment = rods.reaction(0, 0)
    assert force[1] == pytest.approx(0.01, rel=1e-6)
    assert moment[2] == pytest.approx(0.01 * rods.positions(1)[0, 0], rel=1e-5)
    assert rods.tension(1)[0] == pytest.approx(0.01, rel=1e-6)


@pytest.mark.parametrize("at", [-1, 6.5])
def test_a_bracket_welded_to_a_beam(at):
    """A weight at the end of a bracket twists the beam by W b: statics, and the angle W b x / GJ."""
    line, arm, weight = straight((0, 0, 0), (40, 0, 0), 8), 10.0, 1e-3
    place = np.array([40.0 if at == -1 else at * 5.0, 0.0, 0.0])
    rods = Rods([Beam(line, RADIUS, STEEL), beam(place, place + [0, arm, 0], 4)])
    rods.clamp(0, 0)
    rods.tie((1, 0), (0, at))
    rods.force(1, -1, (0.0, 0.0, -weight))
    rods.solve()
    moment = rods.reaction(0, 0)[1]
    assert moment == pytest.approx([weight * arm, -weight * place[0], 0.0], rel=1e-4, abs=1e-8)
    if at != -1:  # elements are smooth: the kink of the twist within one is spread over it
        return
    stiffness = MODULUS / 2.6 * np.pi * RADIUS**4 / 2.0
    twist = weight * arm * place[0] / stiffness
    tangent = np.diff(rods.positions(1)[:2], axis=0)[0]
    # The first span of the bracket bends, too.
    bend = weight * (arm * 2.5 / 2.0 - 2.5**2 / 6.0) / BENDING
    assert -tangent[2] / tangent[1] == pytest.approx(twist + bend, rel=5e-3)


def test_a_hinge_beside_the_line_turns_with_the_section():
    """A cable at the end of a cross arm (a section's outside) turns the beam: torque W e."""
    line, arm, weight = straight((0, 0, 0), (40, 0, 0), 8), 3.0, 1e-3
    hung = Cable(straight((40, arm, 0), (40, arm, -20), 2), 0.1, 1e4)
    rods = Rods([Beam(line, RADIUS, STEEL), hung])
    rods.clamp(0, 0)
    rods.hinge((1, 0), (0, -1))
    rods.force(1, -1, (0.0, 0.0, -weight))
    rods.solve()
    place = rods.positions(1)[0]
    weights = np.cross(place, [0.0, 0.0, -weight])
    assert rods.reaction(0, 0)[1] == pytest.approx(-weights, rel=1e-4, abs=1e-8)
    assert np.linalg.norm(place - rods.positions(0)[-1]) == pytest.approx(arm, rel=1e-5)


def test_cables_that_meet():
    """A weight at a joint of three cables in a plane: T = W / (2 cos) in two, W in the third."""
    tip, weight = (0.0, 0.0, 0.0), 10.0
    ends = [(-30.0, 40.0, 0.0), (30.0, 40.0, 0.0), (0.0, -20.0, 0.0)]
    rods = Rods([Cable(straight(end, tip, 2), 0.1, 1e5) for end in ends])
    for rod in (0, 1):
        rods.pin(rod, 0)
        rods.hinge((rod, -1), (2, -1))
    rods.force(2, 0, (0.0, -weight, 0.0))
    rods.hold(2, slice(None), [2])
    rods.solve(increments=2)
    tensions = [rods.tension(rod)[0] for rod in range(3)]
    # cos = 40 / 50, but for the stretch of 1e-4
    assert tensions == pytest.approx([6.25, 6.25, 10.0], rel=1e-3)


def test_a_beam_welded_to_a_solid():
    """Half solid, half beam, bent by a couple: the clamp holds the couple."""
    halves = straight((0, 0, 0), (10, 0, 0), 4), straight((10, 0, 0), (20, 0, 0), 4)
    rods = Rods([Solid(halves[0], RADIUS, STEEL), Beam(halves[1], RADIUS, STEEL)])
    rods.clamp(0, 0)
    rods.tie((1, 0), (0, -1))
    rods.couple(1, -1, (0.0, 0.0, 20.0))
    rods.solve()
    assert rods.reaction(0, 0)[1] == pytest.approx([0.0, 0.0, -20.0], rel=1e-5, abs=1e-4)
    assert rods.positions(0)[-1] == pytest.approx(rods.positions(1)[0])


def test_joined_rods_do_not_touch_but_others_do():
    lines = [straight((0, 0, 0), (10, 0, 0), 4), straight((5, 0, 0), (5, 9, 0), 4)]
    third = straight((2.5, -5, 0.99), (2.5, 5, 0.99), 4)
    rods = Rods([Beam(x, RADIUS, STEEL) for x in (*lines, third)])
    for rod in (0, 2):
        rods.clamp(rod, [0, -1])
    rods.tie((1, 0), (0, 2))
    rods.solve()
    assert {tuple(sorted(pair)) for pair in rods.contacts()["tubes"].tolist()} == {(0, 2)}


def test_bad_joints_are_named():
    lines = [straight((0, 0, 0), (8, 0, 0), 4), straight((8, 0, 0), (8, 8, 0), 4)]
    rods = Rods([Beam(lines[0], RADIUS, STEEL), Cable(lines[1], RADIUS, 1e3)])
    with pytest.raises(ValueError, match="first is .*: give a rod and the number of one"):
        rods.hinge((0, 1.5), (1, 0))
    with pytest.raises(ValueError, match="rod 1 is a cable, which has no section to tie"):
        rods.tie((1, 0), (0, -1))
    with pytest.raises(ValueError, match="node 0 of rod 0 is 8 mm from the place 0 of rod 1"):
        rods.hinge((0, 0), (1, 0))
    with pytest.raises(IndexError, match="place 4.5 of rod 1: give a number from 0 to 4"):
        rods.hinge((0, -1), (1, 4.5))
    with pytest.raises(IndexError, match="rod 2: there are rods 0 to 1"):
        rods.hinge((0, -1), (2, 0))
    group = rods.rigid([(1, -1)])
    rods.hold(group, 0, slice(3, 12))
    with pytest.raises(
        ValueError, match="2 is a rigid group: make nodes that follow it part of it"
    ):
        rods.hinge((0, -1), (group, 0))
    rods.pin(0, -1)
    with pytest.raises(ValueError, match="node 4 of rod 0 is held: release it"):
        rods.hinge((0, -1), (1, 0))
    rods.hinge((1, 0), (0, -1))
    with pytest.raises(ValueError, match="node 0 of rod 1 is part of a joint"):
        rods.hinge((1, 0), (0, 2))
    rods.release(0, -1)
    with pytest.raises(ValueError, match="in a circle"):
        rods.hinge((0, -1), (1, 0))
    with pytest.raises(ValueError, match="node 0 of rod 1 follows a rigid group or a joint"):
        rods.pin(1, 0)
    rods.clamp(0, -1)
    rods.solve()


def test_two_halves_that_are_tied_swing_like_the_whole():
    """A cantilever let go: the tie has no mass and takes no energy."""
    soft = YarnMaterial.isotropic(1e3, 0.3)
    lines = straight((0, 0, 0), (20, 0, 0), 8), straight((0, 0, 0), (10, 0, 0), 4)
    whole = Rods([Beam(lines[0], 1.0, soft, density=1e-9)])
    halves = Rods([Beam(x, 1.0, soft, density=1e-9) for x in (lines[1], lines[1] + [10, 0, 0])])
    halves.tie((1, 0), (0, -1))
    tips = []
    for rods in (whole, halves):
        last = len(rods.rods) - 1
        rods.clamp(0, 0)
        rods.force(last, -1, (0.0, 0.05, 0.0))
        rods.solve()
        rods.force(last, -1, (0.0, 0.0, 0.0), at_once=True)
        rods.run(5e-3, 1e-3)
        tips.append(rods.positions(last)[-1])
        with pytest.raises(ValueError, match="rods are in motion: join them before `run`"):
            rods.rigid([(0, 2)])
    assert abs(tips[0][1]) < 0.02  # it has left the deflection of 0.17 that it began with
    assert tips[0] == pytest.approx(tips[1], abs=1e-7)
