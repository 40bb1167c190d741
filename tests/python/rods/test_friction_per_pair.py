"""Friction of pairs of bodies: each rod rubs by the coefficient of its own pair."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, Cylinder, Plane, Rods, Sheave, YarnMaterial, straight

MATERIAL = YarnMaterial.isotropic(1e3, 0.3)
RADIUS = 0.5
GROUND = Plane((0, 0, 0), (0, 0, 1))


def two_on_ground(ground=GROUND, **options):
    """Two beams side by side on the ground, not touching each other."""
    lines = [straight((0, y, RADIUS), (4, y, RADIUS), 4) for y in (0.0, 3.0)]
    rods = Rods([Beam(x, RADIUS, MATERIAL) for x in lines], rigid=[ground], **options)
    for rod in (0, 1):
        rods.hold(rod, slice(None), [0, 1, *range(3, 9)])
    return rods


def drag(rods):
    """Pressed on the ground and dragged along it: friction over normal force, of each rod."""
    for rod in (0, 1):
        rods.line_load(rod, (0.0, 0.0, -0.5))
    rods.solve()
    for rod in (0, 1):
        rods.move(rod, slice(None), by=(0.3, 0.0, 0.0))
    rods.solve(increments=2)
    found = rods.contacts()
    assert set(found["tubes"][:, 1]) == {-1}
    out = []
    for rod in (0, 1):
        mine = found["tubes"][:, 0] == rod
        assert found["normal_force"][mine].sum() == pytest.approx(2.0, rel=1e-6)
        out.append(np.linalg.norm(found["friction_force"][mine].sum(axis=0)) / 2.0)
    return out


@pytest.mark.parametrize(
    "ground", [GROUND, engine.make_plane(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0)]
)
def test_each_rod_rubs_on_the_ground_by_its_own_coefficient(ground):
    rods = two_on_ground(ground, friction=0.1)
    rods.friction_between(1, -1, 0.4)
    assert drag(rods) == pytest.approx([0.1, 0.4], rel=1e-6)
    work = 0.3 * 2.0 * (0.1 + 0.4)
    # What reversible slip takes up is not dissipated: a thousandth of a radius.
    assert rods.friction_work == pytest.approx(work, rel=2 * 1e-3 * RADIUS / 0.3)


def test_a_coefficient_of_a_body_is_that_of_all_its_pairs():
    rods = two_on_ground(friction=0.1)
    rods.friction_of(-1, 0.3)
    rods.friction_of(0, 0.0)
    assert drag(rods) == pytest.approx([0.0, 0.3], rel=1e-6, abs=1e-9)


def test_crossing_rods_rub_by_the_coefficient_of_their_pair():
    """Two rods across a third one; it is dragged along its own line."""
    carrier = straight((-4, 0, 0), (4, 0, 0), 8)
    across = [straight((x, -2, 2 * RADIUS), (x, 2, 2 * RADIUS), 4) for x in (-2.2, 1.8)]
    rods = Rods([Beam(x, RADIUS, MATERIAL) for x in (carrier, *across)], friction=0.05)
    rods.friction_between(2, 0, 0.25)
    for rod in (0, 1, 2):
        rods.clamp(rod, slice(None))
    for rod in (1, 2):
        rods.move(rod, slice(None), by=(0.0, 0.0, -0.005))
    rods.move(0, slice(None), by=(0.1, 0.0, 0.0))
    rods.solve()
    found = rods.contacts()
    for rod, coefficient in ((1, 0.05), (2, 0.25)):
        pair = np.sort(found["tubes"], axis=1)
        mine = np.all(pair == [0, rod], axis=1)
        normal = found["normal_force"][mine].sum()
        assert normal > 0.0
        sideways = np.linalg.norm(found["friction_force"][mine], axis=1).sum()
        assert sideways == pytest.approx(coefficient * normal, rel=1e-6)


def test_bad_friction_is_named():
    with pytest.raises(ValueError, match="friction is -0.1: give a coefficient of 0 or more"):
        two_on_ground(friction=-0.1)
    rods = two_on_ground()
    with pytest.raises(ValueError, match="friction is nan"):
        rods.friction_between(0, 1, np.nan)
    with pytest.raises(IndexError, match="body 2: there are rods 0 to 1, and rigid surfaces: -1"):
        rods.friction_between(0, 2, 0.1)


def test_rigid_surfaces_are_those_of_the_engine():
    points, point, axis = np.array([[30.0, 4.0, -2.0]]), (1.0, 2.0, 3.0), np.array([0.0, 0.6, 0.8])
    ours = [
        Plane(point, axis),
        Cylinder(point, axis, 5.0),
        Cylinder(point, axis, 90.0, hollow=True),
        Sheave(point, axis, 20.0, 2.0),
    ]
    at = np.array(point)
    theirs = [
        engine.make_plane(at, axis, 0),
        engine.make_cylinder(at, axis, 5.0, False, 0),
        engine.make_cylinder(at, axis, 90.0, True, 0),
        engine.make_sheave(at, axis, 20.0, 2.0, 0),
    ]
    for mine, other in zip(ours, theirs, strict=True):
        assert mine.surface(3).distances(points) == other.distances(points)
    with pytest.raises(ValueError, match="axis is .*: give a direction"):
        Cylinder(point, (0, 0, 0), 1.0).surface(0)
