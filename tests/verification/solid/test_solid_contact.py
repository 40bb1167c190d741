"""C9 with solids of degree 1: two rods of hexahedra, or one and a beam, that cross askew, pressed and dragged."""

import pytest

from braidx.rods import Beam, Rods, Solid, YarnMaterial, straight

RADIUS, LENGTH, FRICTION = 1.0, 10.0, 0.2
MATERIAL = YarnMaterial.isotropic(1e3, 0.3)
LINES = (
    straight((0, -0.5, -LENGTH / 2), (0, 0.5, LENGTH / 2), 12),
    straight((2 * RADIUS, -LENGTH / 2, -2), (2 * RADIUS, LENGTH / 2, 2.5), 12),
)
MOMENTS = (
    "particles in contact are a penetration apart, and friction acts on each of them; facets are smoothed besides, so "
    "that normals are not quite the direction from one particle to the other."
)


def solid(line):
    return Solid(line, RADIUS, MATERIAL, degree=1)


def beam(line):
    return Beam(line, RADIUS, MATERIAL)


def dragged(kinds, order=(0, 1)):
    """Ends of both rods clamped; rod LINES[1] pressed into the other and dragged along."""
    pair = [kinds[i](LINES[i]) for i in order]
    rods = Rods(pair, friction=FRICTION, tolerance=1e-10)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    rods.move(order.index(1), [0, -1], by=(-0.4, 0.1, 0.2))
    rods.solve(increments=2)
    return rods


@pytest.mark.parametrize(
    "name, kinds", [("solids", (solid, solid)), ("beam on solid", (solid, beam))]
)
def test_pair(record, name, kinds):
    rods, swapped = dragged(kinds), dragged(kinds, (1, 0))
    ends = [(rod, end) for rod in (0, 1) for end in (0, -1)]
    force, moment = rods.resultant(ends, about=(0, 0, 0))
    normal, size = rods.contacts()["normal_force"].sum(), rods.q.size
    record.check("C9", f"{name}: sum of forces", force, 0.0, 1e-9, scale=normal, unknowns=size)
    options = {"scale": normal * 2.0 * RADIUS, "missed": MOMENTS, "measured": 1e-2}
    record.check("C9", f"{name}: sum of moments", moment, 0.0, 1e-9, unknowns=size, **options)
    for rod in (0, 1):
        what, got = f"{name}, swapped: positions over the radius", swapped.positions(1 - rod)
        expected = rods.positions(rod)
        record.check("C9", what, got, expected, 1e-6, scale=RADIUS, unknowns=size)
