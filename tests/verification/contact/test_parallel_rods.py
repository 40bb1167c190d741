"""C6 and C7: parallel rods in line contact, whatever their meshes (exact)."""

import braidx_engine as engine
import numpy as np
import pytest

from braidx.rods import Beam, Cable, Rods, YarnMaterial, straight

RADIUS, LENGTH = 1.0, 20.0
PENALTY = 500.0  # N/mm per mm


def pressed(num_elements, shift, load, beams=True):
    """A rod pressed by a line load (N/mm) onto one that is held, its mesh and ends shifted along it."""
    start = -LENGTH / 2 + shift
    lines = [
        straight((0, 0, -LENGTH), (0, 0, LENGTH), 16),
        straight((2 * RADIUS, 0, start), (2 * RADIUS, 0, start + LENGTH), num_elements),
    ]
    if beams:
        material = YarnMaterial.isotropic(1e4, 0.0)
        pair = [Beam(line, RADIUS, material, degree=1) for line in lines]
    else:
        pair = [Cable(line, RADIUS, 1e4, tension=100.0, degree=1) for line in lines]
    rods = Rods(pair, penalty=PENALTY, penetration=None, tolerance=1e-9)
    rods.hold(0)
    rods.hold(1, components=slice(1, None))
    rods.line_load(1, (-load, 0.0, 0.0))
    rods.solve()
    return rods


MESHES = [(10, 0.0), (10, 0.37), (13, 0.0), (13, 1.1), (31, -0.83)]


@pytest.mark.parametrize("beams", [True, False], ids=["beams", "cables"])
@pytest.mark.parametrize("num_elements, shift", MESHES)
def test_patch(record, num_elements, shift, beams):
    """C6: forces sum to q L, penetration is q / k.

    Loads go to the nodes of straight elements, contact to those of a smooth curve, which is a parabola
    at the ends. A beam levels the difference out: it is judged one element off its ends. A cable has
    no bending stiffness; the difference falls by four from node to node, and it is judged four off.
    """
    load = 2.5
    rods = pressed(num_elements, shift, load, beams)
    contacts, size = rods.contacts(), rods.q.size
    kind = "beams" if beams else "cables"
    held = sum(rods.reaction(0, node)[0][0] for node in range(17))
    sums = [contacts["normal_force"].sum(), held]
    record.check("C6", f"patch of {kind}: sum q L", sums, load * LENGTH, 1e-6, unknowns=size)
    penetration = -contacts["gap"] - rods.contact.laws.regularisation / 2
    s, off = contacts["s"][:, 1], 1 if beams else 4
    penetration = penetration[(s > off) & (s < num_elements - off)]
    what = f"patch of {kind}: penetration q / k"
    record.check("C6", what, penetration, load / PENALTY, 0.01, unknowns=size)


def test_seven_rods(record):
    """C7: six rods pressed onto a seventh by a bore: six equal forces on the core, six on the bore."""
    angle = np.pi / 3 * np.arange(6)
    places = [(0.0, 0.0), *zip(2 * RADIUS * np.cos(angle), 2 * RADIUS * np.sin(angle))]
    seven = [Cable(straight((x, y, 0), (x, y, LENGTH), 12), RADIUS, 1e4, 50.0) for x, y in places]
    axis = np.array([0.0, 0.0, 1.0])
    bore = engine.make_cylinder(0 * axis, axis, 3 * RADIUS - 0.02, True, 0)
    options = {"penalty": PENALTY, "penetration": None, "tolerance": 1e-9}
    rods = Rods(seven, rigid=[bore], viscosity=20.0, **options)  # all six may turn about the core
    for rod in range(7):
        rods.hold(rod, components=[2])
    for _ in range(4):
        rods.solve()
    contacts = rods.contacts()
    a, b = contacts["tubes"].T
    force = contacts["normal_force"]
    core = np.array([force[(a == 0) & (b == rod)].sum() for rod in range(1, 7)])
    wall = np.array([force[(a == rod) & (b < 0)].sum() for rod in range(1, 7)])
    beside = force[(a > 0) & (b > 0)].sum() / 6
    size = rods.q.size
    record.check("C7", "seven rods: force on the core", core, core.mean(), 1e-6, unknowns=size)
    outside = core.mean() + beside
    record.check("C7", "seven rods: force on the bore", wall, outside, 1e-6, unknowns=size)
    assert core.mean() > 1
