"""V2 and V3: cantilever under a dead tip load, and the same at growing slenderness."""

import numpy as np
import pytest
from slender import ELASTICA, tip_of

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial, straight

TABLE = np.array(list(ELASTICA.values()))


def cantilever(section, material, num_elements, degree=2, **options):
    """Length and EI are 1; clamped at the origin, along x."""
    line = straight((0, 0, 0), (1, 0, 0), num_elements * degree)
    rods = Rods([Beam(line, 0.01, material, section, degree=degree, **options)], tolerance=1e-9)
    rods.clamp(0, 0)
    return rods


def tip(rods):
    """Shortening, deflection and angle of the tip at the tabulated loads, shape (4, 3)."""
    results, before = [], 0.0
    for load in ELASTICA:
        rods.force(0, -1, (0.0, load, 0.0))
        rods.solve(increments=round((load - before) / 0.5))
        results.append(tip_of(rods))
        before = load
    return np.array(results)


def shear_rigid(num_elements, degree):
    section = BeamSection(1e8, 1.0, 1.0, 2.0, 1e8)
    return cantilever(section, YarnMaterial(1.0, 1.0, 0.5), num_elements, degree)


def slender(slenderness, num_elements):
    """Round rod of diameter 1 / slenderness, EI = 1, nu = 0, linear in the stretch of its fibres as the table is."""
    section = BeamSection.round(0.5 / slenderness)
    material = YarnMaterial.isotropic(1.0 / section.inertia_1, 0.0)
    return cantilever(section, material, num_elements, axial_law="linear")


def test_table(record):
    rods = shear_rigid(16, 2)
    for load, got, expected in zip(ELASTICA, tip(rods), TABLE):
        for name, *values in zip(("shortening/L", "deflection/L", "tip angle"), got, expected):
            what = f"cantilever, P L^2/EI = {load:g}: {name}"
            record.check("V2", what, *values, 5e-6, scale=1.0, unknowns=rods.q.size)


@pytest.mark.parametrize("degree, order", [(1, 1.8), (2, 3.0)])
def test_order(record, degree, order):
    meshes = (4, 8, 16)
    errors = [np.abs(tip(shear_rigid(n, degree)) - TABLE).max() for n in meshes]
    what = f"cantilever, tip, degree {degree}"
    record.converges("V2", what, meshes, errors, order)


@pytest.mark.parametrize("slenderness, tolerance", [(1e1, 1e-2), (1e2, 1e-4), (1e3, 5e-6)])
def test_slenderness(record, slenderness, tolerance):
    """The deviation is that of the extensible, shear-soft rod, of the order of (d / L)^2."""
    what = f"cantilever, L/d = {slenderness:g}: table of V2"
    rods = slender(slenderness, 16)
    record.check("V3", what, tip(rods), TABLE, tolerance, scale=1.0, unknowns=rods.q.size)


def test_no_shear_locking(record):
    """One in ten thousand: the same mesh gives the same error as the shear-rigid rod."""
    for num_elements, tolerance in ((8, 1e-4), (16, 5e-6)):
        rods = slender(1e4, num_elements)
        what = f"cantilever, L/d = 1e4, {num_elements} elements: table of V2"
        record.check("V3", what, tip(rods), TABLE, tolerance, scale=1.0, unknowns=rods.q.size)
