"""V4 and V5: arc of 45 degrees under a dead load out of its plane.

Reference values: exact, of the shear-deformable rod (V4) and of Kirchhoff's (V5), integrated as boundary value problems
of ordinary differential equations. Published values of coarse meshes differ by up to 4 %.
"""

import numpy as np
import pytest
from slender import ARC_RADIUS, ARC_TIP, arc_of_45_degrees

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial

KIRCHHOFF = np.array([-23.55938, -13.60424, 53.46860])


def bend(side, load, num_elements, degree, transverse_modulus=1e7):
    """Displacement of the tip, shape (3,), and the scene; square section."""
    line, directors = arc_of_45_degrees(num_elements * degree)
    inertia = side**4 / 12.0
    section = BeamSection(side**2, inertia, inertia, 2.0 * inertia, side**2)
    material = YarnMaterial(1e7, transverse_modulus, 0.5e7)
    rods = Rods([Beam(line, side / 2.0, material, section, directors, degree)])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.0, load))
    rods.solve(increments=6)
    return rods.positions(0)[-1] - line[-1], rods


def test_displacement(record):
    """Sections that hardly deform, as the exact value assumes."""
    tip, rods = bend(1.0, 600.0, 16, 2, transverse_modulus=1e9)
    size, unknowns = np.linalg.norm(ARC_TIP), rods.q.size
    for name, *values in zip("xyz", tip, ARC_TIP):
        what = f"45 degree arc, load 600: tip u_{name}"
        record.check("V4", what, *values, 1e-4, scale=size, unknowns=unknowns)


@pytest.mark.parametrize("degree, order", [(1, 1.8), (2, 2.8)])
def test_order(record, degree, order):
    fine, rods = bend(1.0, 600.0, 32, 2)
    meshes = (4, 8, 16) if degree == 1 else (2, 4, 8)
    errors = [np.linalg.norm(bend(1.0, 600.0, n, degree)[0] - fine) / ARC_RADIUS for n in meshes]
    what = f"45 degree arc, tip, degree {degree}"
    record.converges("V4", what, meshes, errors, order, unknowns=rods.q.size)


@pytest.mark.parametrize("slenderness, tolerance", [(1e2, 2e-4), (1e3, 1e-5), (1e4, 1e-5)])
def test_no_membrane_locking(record, slenderness, tolerance):
    side = ARC_RADIUS / slenderness
    tip, rods = bend(side, 600.0 * side**4, 16, 2)
    what = f"45 degree arc, R/side = {slenderness:g}: tip"
    scale = np.linalg.norm(KIRCHHOFF)
    record.check("V5", what, tip, KIRCHHOFF, tolerance, scale=scale, unknowns=rods.q.size)
