"""C9: two rods that cross askew, pressed and dragged: forces balance, and it is the same pair when swapped (exact)."""

import numpy as np

from braidx.rods import Beam, Rods, YarnMaterial, straight

RADIUS = 1.0
LINES = (
    straight((0, -1, -9), (0, 1, 9), 16),
    straight((2 * RADIUS, -8, -4), (2 * RADIUS, 8, 5), 20),
)


MOMENTS = (
    "friction of beams acts at one point only where their sections contain the normal. At line stations of beams that "
    "cross they do not, so that the two particles are a little aside of each other."
)


def dragged(order):
    """Ends of both rods clamped; rod LINES[1] pressed into the other and dragged along."""
    material = YarnMaterial.isotropic(1e3, 0.3)
    pair = [Beam(LINES[i], RADIUS, material) for i in order]
    rods = Rods(pair, friction=0.2, tolerance=1e-11, penalty=1e3, penetration=None)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    rods.move(order.index(1), [0, -1], by=(-0.5, 0.1, 0.2))
    rods.solve(increments=3)
    return rods


def wrench(rods):
    """Sum of the reactions, and of their moments about the origin; N, N mm."""
    forces, moments = np.zeros(3), np.zeros(3)
    for rod in (0, 1):
        for end in (0, -1):
            force, moment = rods.reaction(rod, end)
            forces += force
            moments += moment + np.cross(rods.positions(rod)[end], force)
    return forces, moments


def test_pair(record):
    rods, swapped = dragged((0, 1)), dragged((1, 0))
    size, normal = rods.q.size, rods.contacts()["normal_force"].sum()
    forces, moments = wrench(rods)
    record.check("C9", "pair: sum of forces", forces, 0.0, 1e-9, scale=normal, unknowns=size)
    options = {"scale": normal * 2.0 * RADIUS, "missed": MOMENTS, "measured": 2e-4}
    record.check("C9", "pair: sum of moments", moments, 0.0, 1e-9, unknowns=size, **options)
    for rod in (0, 1):
        what, scale = "pair swapped: positions over the radius", RADIUS
        got, expected = swapped.positions(1 - rod), rods.positions(rod)
        record.check("C9", what, got, expected, 1e-8, scale=scale, unknowns=size)
