"""V10: an end couple along the axis winds a straight rod with EI = GJ to an exact helix.

kappa EI b + tau GJ t of a helix, with kappa = r / (r^2 + c^2), tau = c / (r^2 + c^2), is EI / sqrt(r^2 + c^2) along the
axis.
"""

import numpy as np
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial, straight

HELIX, HEIGHT, COILS = 10.0, 50.0, 2
RISE = HEIGHT / (2.0 * np.pi * COILS)  # per radian
PER_RADIAN = np.hypot(HELIX, RISE)  # arc length
LENGTH = 2.0 * np.pi * COILS * PER_RADIAN
STIFF = 1e5  # area over inertia, 1/mm^2: strains of 1e-7
AXIS = np.array([0.0, 0.0, 1.0])


def helix(angle):
    """Positions at angles about the axis, from the origin on, shape (n, 3)."""
    return np.stack([HELIX * (np.cos(angle) - 1.0), HELIX * np.sin(angle), RISE * angle], axis=-1)


def wound(num_elements):
    """The equilibrium near the exact helix; the way there from the straight rod takes some 1500 iterations.

    With EI = GJ the rod turns about the axis at a constant rate.
    """
    tangent = np.array([0.0, HELIX, RISE]) / PER_RADIAN
    line = straight((0, 0, 0), tuple(LENGTH * tangent), 2 * num_elements)
    section = BeamSection(STIFF, 1.0, 1.0, 2.0, STIFF)
    rods = Rods([Beam(line, 0.01, YarnMaterial(1.0, 1.0, 0.5), section)])
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, 1.0 / PER_RADIAN))
    angle = np.linspace(0.0, 2.0 * np.pi * COILS, len(line))
    turn = Rotation.from_rotvec(np.outer(angle, AXIS))
    directors = [turn.apply(g) for g in rods.directors(0).swapaxes(0, 1)]
    rods.solve(guess=np.hstack([helix(angle), *directors]).ravel())
    return rods


def error(rods):
    """Largest distance of a node from its place on the helix, over the radius."""
    x = rods.positions(0)
    exact = helix(np.linspace(0.0, 2.0 * np.pi * COILS, len(x)))
    return np.abs(x - exact).max() / HELIX


def test_helix(record):
    meshes = (16, 32, 64)
    scenes = [wound(n) for n in meshes]
    size, what = scenes[-1].q.size, "couple along the axis winds a helix: "
    x = scenes[-1].positions(0)[-1]
    record.check("V10", what + "height", x[2], HEIGHT, 1e-4, unknowns=size)
    record.converges("V10", what + "nodes", meshes, [error(s) for s in scenes], 3.5, largest=1e-4)
