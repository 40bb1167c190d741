"""Ends of cables and beams: half spheres of the rod's radius."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, Solid, YarnMaterial, straight

MATERIAL = YarnMaterial.isotropic(1000.0, 0.0)
AREA = np.pi
PENETRATION = 0.005


def beam(begin, end, spans=4):
    return Beam(straight(begin, end, spans), 1.0, MATERIAL, degree=1)


def axial_force(stretch):
    """Of a rod of radius 1 with the law of Saint-Venant and Kirchhoff, N, positive when pushed."""
    return -1000.0 * AREA * stretch * (stretch**2 - 1.0) / 2.0


def pushed(other=None, rigid=(), friction=0.0, towards=(0.0, 0.0, -1.0)):
    """A beam of length 8 along z, its lower end a radius above the origin, pushed down by 0.05."""
    rods = Rods(
        [beam((0, 0, 1), (0, 0, 9)), *([] if other is None else [other])],
        rigid=rigid,
        friction=friction,
        penetration=PENETRATION,
    )
    rods.clamp(0, -1)
    rods.hold(0, 0, [0, 1])
    if other is not None:
        rods.clamp(1, [0, -1])
    rods.move(0, -1, by=0.05 * np.array(towards))
    rods.solve()
    return rods


OTHERS = {
    "side of a beam": beam((-1, 0, -1), (1, 0, -1), 2),
    "end of a beam": beam((0, 0, -9), (0, 0, -1)),
    "end of a cable": Cable(straight((0, 0, -9), (0, 0, -1), 4), 1.0, 1e5, 10.0),
    "face of a solid": Solid(straight((0, 0, -3), (0, 0, 0), 2), 1.0, MATERIAL, degree=1),
    "plane": None,
}


@pytest.mark.parametrize("other", OTHERS)
def test_a_beam_pushed_with_its_end(other):
    """It stops a radius before what it meets, and the force is that of its strain, along its axis."""
    plane = engine.make_plane(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0)
    rods = pushed(OTHERS[other], [plane] if other == "plane" else [])
    end = rods.positions(0)[0, 2]
    contacts = rods.contacts()
    force = rods.reaction(0, -1)[0]
    length = rods.positions(0)[-1, 2] - end
    assert force == pytest.approx([0.0, 0.0, -axial_force(length / 8.0)], rel=1e-6, abs=1e-6)
    assert -force[2] > 1.0
    assert contacts["normal_force"].sum() == pytest.approx(-force[2], rel=1e-6)
    assert -PENETRATION <= contacts["gap"].min() < 0.0
    if other == "plane":
        assert 1.0 - PENETRATION <= end < 1.0
    else:
        below = [rods.reaction(1, node)[0] for node in (0, -1)]
        assert np.sum(below, axis=0) == pytest.approx(-force, abs=1e-5)


def slide(rod, step, until):
    """A beam across a rod on which it presses, moved along x over its end, x = 0.

    Returns:
        Places, shape (n,), forces on the beam, shape (n, 3), and distances of its axis from the end, shape (n,).
    """
    rods = Rods([rod, beam((0, -4, 2), (0, 4, 2), 8)], penetration=PENETRATION)
    rods.clamp(0, [0, -1])
    rods.clamp(1, [0, -1])
    rods.move(1, [0, -1], by=(0.0, 0.0, -0.1))
    rods.solve()
    rods.move(1, [0, -1], by=(-0.3, 0.0, 0.0))
    rods.solve()
    places, forces, distances = [], [], []
    while True:
        places.append(rods.positions(1)[0, 0])
        forces.append(-rods.reactions(1, [0, -1])[0].sum(axis=0))
        way = rods.positions(1)[4] - rods.positions(0)[-1]
        distances.append(np.linalg.norm(way[[0, 2]]))
        if places[-1] > until - 1e-9:
            return np.array(places), np.array(forces), np.array(distances)
        rods.move(1, [0, -1], by=(step, 0.0, 0.0))
        rods.solve()


@pytest.mark.parametrize("kind", ["beam", "cable"])
def test_a_beam_slides_over_the_end_of_a_rod(kind):
    """No step changes the force by more than stiffness, up to the place where the half sphere is left."""
    line = straight((-6, 0, 0), (0, 0, 0), 6)
    rod = beam(line[0], line[-1], 6) if kind == "beam" else Cable(line, 1.0, 1e5, 200.0, degree=1)
    places, force, distance = slide(rod, 0.1, 0.7)
    stiffness = force[:, 2].max() / 0.1
    assert np.all(np.linalg.norm(np.diff(force, axis=0), axis=1) < stiffness * np.diff(places))
    assert force[0, 2] > 1.0 and force[-1] == pytest.approx(0.0, abs=1e-6)
    assert force[:, 0].max() > 0.1 * force[0, 2]  # the half sphere pushes the beam on
    assert distance[places > 0].min() > 2.0 - 2 * PENETRATION


def test_friction_at_an_end():
    """A beam that stands on a plane and is moved along it is held back by mu N."""
    plane = engine.make_plane(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0)
    rods = pushed(rigid=[plane], friction=0.2)
    rods.move(0, 0, by=(0.1, 0.0, 0.0))
    rods.move(0, -1, by=(0.1, 0.0, 0.0))
    rods.solve()
    contacts = rods.contacts()
    normal = contacts["normal_force"].sum()
    assert normal > 1.0
    friction = sum(rods.reaction(0, node)[0][0] for node in (0, -1))
    assert friction == pytest.approx(0.2 * normal, rel=1e-5)
