"""Ends of solids: flat faces and edges that touch as any other part of their skin."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.meshing import rectangle
from braidx.rods import Beam, Rods, Solid, YarnMaterial, straight

SIDE, LENGTH, MODULUS = 1.0, 3.0, 1000.0
FRAME = np.eye(3)[1:]
PRESSED = 0.15  # mm, how deep a beam is pressed on a solid


def bar(start, counts=(2, 2), degree=1):
    """A square bar along x, which does not bulge."""
    start = np.array(start, dtype=float)
    line = straight(start, start + [LENGTH, 0, 0], 3 * degree)
    section = rectangle(SIDE, SIDE, counts, degree)
    frame = np.broadcast_to(FRAME, (len(line), 2, 3))
    return Solid(line, SIDE / 2, YarnMaterial.isotropic(MODULUS, 0.0), section, frame)


def axial_force(stretch):
    """Of a bar with the law of Saint-Venant and Kirchhoff, N, positive when pushed."""
    return -MODULUS * SIDE**2 * stretch * (stretch**2 - 1.0) / 2.0


@pytest.mark.parametrize("others, degree", [((2, 2), 1), ((3, 3), 1), ((2, 2), 2)])
def test_bars_pushed_end_to_end(others, degree):
    """Even pressure: both shorten alike, and the force is that of their strain."""
    rods = Rods([bar((0, 0, 0), degree=degree), bar((LENGTH, 0, 0), others, degree)])
    rods.clamp(0, 0)
    rods.clamp(1, -1)
    rods.move(1, -1, by=(-0.06, 0.0, 0.0))
    rods.solve()
    ends = [rods.positions(0)[-1, 0], rods.positions(1)[0, 0]]
    depth = ends[0] - ends[1]
    assert 0.0 < depth < 0.01 * SIDE
    force = rods.reaction(0, 0)[0]
    assert force == pytest.approx([axial_force(ends[0] / LENGTH), 0.0, 0.0], rel=1e-6, abs=1e-6)
    assert rods.reaction(1, -1)[0] == pytest.approx(-force, abs=1e-6)
    assert ends[0] + ends[1] == pytest.approx(2 * LENGTH - 0.06, abs=1e-7)
    contacts = rods.contacts()
    assert contacts["weight"].sum() == pytest.approx(SIDE**2, rel=1e-9)
    assert contacts["normal_force"].sum() == pytest.approx(force[0], rel=1e-6)
    if others == (2, 2):  # facets that match
        pressure = contacts["normal_force"] / contacts["weight"]
        assert pressure == pytest.approx(force[0] / SIDE**2, rel=1e-6)


def test_a_bar_pushed_against_a_plane():
    plane = engine.make_plane(np.array([LENGTH, 0.0, 0.0]), np.array([-1.0, 0.0, 0.0]), 0)
    rods = Rods([bar((0, 0, 0))], rigid=[plane])
    rods.clamp(0, 0)
    rods.move(0, 0, by=(0.05, 0.0, 0.0))
    rods.solve()
    end = rods.positions(0)[-1, 0]
    assert LENGTH < end < LENGTH + 0.01 * SIDE
    force = axial_force((end - 0.05) / LENGTH)
    assert rods.reaction(0, 0)[0] == pytest.approx([force, 0.0, 0.0], rel=1e-6, abs=1e-6)
    contacts = rods.contacts()
    assert contacts["normal_force"] / contacts["weight"] == pytest.approx(force / SIDE**2)


def test_sides_of_bars_touch_at_their_nodes():
    """Nodes of a square section stand for no circle: its sides are where they are."""
    upper = bar((0, 0, SIDE))
    rods = Rods([bar((0, 0, 0)), upper])
    rods.contact.update(rods.q)
    gaps = rods.contacts()["gap"]
    assert len(gaps) and np.abs(gaps).max() < 1e-12


def slide(step, until):
    """A beam across a solid that it presses on, moved along it over its end, x = 0, in steps.

    Returns:
        Places, shape (n,), forces of the solid on the beam, shape (n, 3), and nearest distances of the beam's axis from
        the solid, shape (n,).
    """
    material = YarnMaterial.isotropic(1000.0, 0.3)
    solid = Solid(straight((-4, 0, 0), (0, 0, 0), 4), 1.0, material)
    beam = Beam(straight((0, -4, 2), (0, 4, 2), 8), 1.0, material, degree=1)
    rods = Rods([solid, beam], penetration=0.005)
    rods.clamp(0, 0)
    rods.clamp(1, [0, -1])
    rods.move(1, [0, -1], by=(0.0, 0.0, -PRESSED))
    rods.solve()
    places, forces, distances = [], [], []
    while True:
        contacts = rods.contacts()
        away = np.linalg.norm((contacts["position"] - rods.positions(1)[4])[:, [0, 2]], axis=1)
        places.append(rods.positions(1)[0, 0])
        forces.append(-rods.reactions(1, [0, -1])[0].sum(axis=0))
        distances.append(away.min(initial=np.inf))
        total = (contacts["normal_force"][:, None] * contacts["normal"]).sum(axis=0)
        assert total == pytest.approx(-forces[-1], abs=1e-5)
        if places[-1] > until - 1e-9:
            return np.array(places), np.array(forces), np.array(distances)
        rods.move(1, [0, -1], by=(step, 0.0, 0.0))
        rods.solve()


def test_a_beam_slides_over_the_end_of_a_solid():
    """The force turns about the edge and falls to nothing without a jump: no step changes it by more than stiffness."""
    coarse, fine = (slide(step, 0.5) for step in (0.1, 0.05))
    assert fine[1][::2] == pytest.approx(
        coarse[1], abs=1e-4
    )  # without friction the way is no matter
    force = fine[1]
    stiffness = force[0, 2] / PRESSED  # of beam and solid together
    for places, forces, _ in (coarse, fine):
        changes = np.linalg.norm(np.diff(forces, axis=0), axis=1)
        assert np.all(changes < stiffness * np.diff(places))
    assert force[0, 2] > 1.0 and abs(force[0, 0]) < 0.1 * force[0, 2]
    assert np.all(np.diff(force[:, 2]) <= 1e-6) and force[-1] == pytest.approx(0.0, abs=1e-9)
    assert force[:, 0].max() > 0.2 * force[0, 2]  # the edge pushes the beam on
    assert fine[2].min() > 1.0 - 0.02  # but for penetration, 0.005, and a squeezed section
