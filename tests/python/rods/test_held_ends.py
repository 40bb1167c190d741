"""Held nodes that are told to be within each other, or within a rigid surface, are refused."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, Cable, NotConverged, Rods, YarnMaterial, ring, straight
from braidx.rods.chords import chord_distances

SOFT = YarnMaterial.isotropic(1000.0, 0.3)


def beams(shift=0.0, **options):
    """Two clamped beams of radius 1 along x, 3 mm above each other; the ends of the upper one are `shift` beside."""
    lines = [straight((0, 0, 0), (20, 0, 0), 8), straight((0, shift, 3), (20, -shift, 3), 8)]
    rods = Rods([Beam(line, 1.0, SOFT) for line in lines], **options)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    return rods


def test_ends_told_to_overlap_are_named_with_their_distance():
    rods = beams(shift=0.5)
    rods.move(1, [0, -1], by=(0.0, 0.0, -2.0))
    with pytest.raises(NotConverged) as caught:
        rods.solve(4)
    message = str(caught.value)
    assert "no equilibrium at 0.75 of the way, after 2 increments" in message
    assert "node 0 of rod 0 and node 0 of rod 1 would be 1.581 mm apart" in message
    assert "Try" not in message  # no cure of those for hard increments is one
    assert rods.positions(1)[0, 2] == pytest.approx(2.0)  # where the last equilibrium was


def test_ends_that_pass_beside_each_other_are_not_refused():
    rods = beams(shift=2.1)
    rods.move(1, [0, -1], by=(0.0, 0.0, -1.5))
    rods.solve(2)
    assert len(rods.contacts()["gap"]) > 0


def test_rods_that_do_not_touch_may_overlap():
    rods = beams(contact=False)
    rods.move(1, [0, -1], by=(0.0, 0.0, -3.0))
    rods.solve(1)
    assert rods.positions(1)[0, 2] == pytest.approx(0.0)


def test_overlap_at_rest_is_what_the_rods_were_made_like():
    lines = [straight((0, 0, z), (20, 0, z), 8) for z in (0.0, 1.8)]
    rods = Rods([Beam(line, 1.0, SOFT) for line in lines], penalty=10.0, penetration=None)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
        rods.move(rod, -1, by=(0.1, 0.0, 0.0))
    rods.solve(1)
    assert rods.contacts()["gap"].min() < 0.0


def test_an_open_ring_that_may_touch_itself_is_refused():
    with pytest.raises(ValueError, match="rod 0 may touch itself.*closed=True"):
        Rods([Beam(ring(10.0, 32), 1.0, SOFT)], self_contact=5.0)


def test_chords_of_held_neighbours_are_looked_at():
    """Held rods whose nodes are apart, but not what is between them."""
    lines = [straight((-10, 0, 0), (10, 0, 0), 2), straight((5, -10, 3), (5, 10, 3), 3)]
    rods = Rods([Cable(line, 1.0, 1e4, tension=10.0, degree=1) for line in lines])
    for rod in (0, 1):
        rods.pin(rod, slice(None))
    rods.move(1, slice(None), by=(0.0, 0.0, -1.5))
    with pytest.raises(NotConverged, match="nodes 1 to 2 of rod 0 and nodes 1 to 2 of rod 1"):
        rods.solve(1)


def test_held_nodes_within_a_rigid_surface():
    plane = engine.make_plane(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0)
    rods = Rods([Beam(straight((0, 0, 2), (20, 0, 2), 8), 1.0, SOFT)], rigid=[plane])
    rods.clamp(0, [0, -1])
    rods.move(0, -1, by=(0.0, 0.0, -1.5))
    with pytest.raises(NotConverged, match="node 8 of rod 0 would be 0.5 mm from the rigid surf"):
        rods.solve(1)


def test_distances_of_rigid_surfaces_have_a_sign():
    drum = engine.make_cylinder(np.zeros(3), np.array([0.0, 0.0, 1.0]), 3.0, False, 0)
    bore = engine.make_cylinder(np.zeros(3), np.array([0.0, 0.0, 1.0]), 3.0, True, 0)
    points = np.array([[5.0, 0.0, 7.0], [0.0, 1.0, 0.0]])
    assert drum.distances(points) == pytest.approx([2.0, -2.0])
    assert bore.distances(points) == pytest.approx([-2.0, 2.0])


def test_distances_of_chords_against_a_fine_sampling():
    random = np.random.default_rng(1)
    a, b, c, d = random.normal(size=(4, 40, 3))
    b[:5] = a[:5]  # points
    d[3:8] = c[3:8]
    d[8:11] = c[8:11] + 0.5 * (b - a)[8:11]  # parallel
    share = np.linspace(0.0, 1.0, 301)[:, None, None]
    first, second = a + share * (b - a), c + share * (d - c)
    sampled = [
        np.linalg.norm(first[:, None, k] - second[None, :, k], axis=-1).min() for k in range(40)
    ]
    found = chord_distances(a, b, c, d)
    assert np.all(found <= np.array(sampled) + 1e-12)
    assert found == pytest.approx(sampled, abs=0.02)
