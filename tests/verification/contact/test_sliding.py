"""C8: a rod that slides along an arc over many of its elements: the same force everywhere, friction mu N (exact)."""

import numpy as np
import pytest

from braidx.rods import Beam, Rods, YarnMaterial, arc, straight

RADIUS, BEND = 1.0, 30.0  # of the rods, of the arc, mm
CENTRE = np.array([0.0, BEND, 0.0])
ELEMENTS, STATIONS = 24, 31  # of the arc; places looked at
FRICTION = 0.2


def slide(degree, friction):
    """Normal force, and moment about the centre over its arm, at places along three elements; shape (n, 2), N.

    The slider crosses the arc outside and is pressed on it by its clamped ends, which go round the centre.
    """
    material = YarnMaterial.isotropic(1e4, 0.3)
    angle = np.pi / 2.0
    lines = [arc(BEND, angle, ELEMENTS * degree)]
    start = 0.4 * angle
    out = np.array([np.sin(start), -np.cos(start), 0.0])
    middle = CENTRE + (BEND + 2.0 * RADIUS) * out
    along = np.array([0.0, 0.0, 8.0])
    lines.append(straight(middle - along, middle + along, 24))
    pair = [Beam(lines[0], RADIUS, material, degree=degree), Beam(lines[1], RADIUS, material)]
    rods = Rods(pair, friction=friction, penalty=2e4, penetration=None)
    rods.hold(0)
    rods.clamp(1, [0, -1])
    rods.move(1, [0, -1], by=-0.02 * out)
    rods.solve()
    results = []
    for _ in range(STATIONS):
        rods.move(1, [0, -1], turn=(0.0, 0.0, 3.0 * angle / ELEMENTS / STATIONS), about=CENTRE)
        rods.solve()
        moment = 0.0
        for end in (0, -1):
            force, couple = rods.reaction(1, end)
            moment += couple[2] + np.cross(rods.positions(1)[end] - CENTRE, force)[2]
        results.append((rods.contacts()["normal_force"].sum(), moment / (BEND + RADIUS)))
    return np.array(results), rods.q.size


@pytest.mark.parametrize("degree", [1, 2])
def test_ripple(record, degree):
    """The ripple is that of a straight element's sagitta and of places where the tube is smoothed."""
    results, size = slide(degree, 0.0)
    normal = results[:, 0]
    what = f"sliding, elements of degree {degree}: normal force over its mean"
    record.check("C8", what, normal / normal.mean(), 1.0, 1e-3, unknowns=size)


@pytest.mark.parametrize("degree", [1, 2])
def test_friction(record, degree):
    results, size = slide(degree, FRICTION)
    normal, friction = results[3:].T  # the first steps are reversible
    what = f"sliding, elements of degree {degree}: friction over mu N"
    record.check("C8", what, friction / (FRICTION * normal), 1.0, 1e-3, unknowns=size)
