"""V1 to V8 with solids in the place of beams: what holds for a slender rod holds for hexahedra."""

import numpy as np
import pytest
from slender import ARC_TIP, ELASTICA, arc_of_45_degrees, circle, tip_of

from braidx.meshing import rectangle, round_section
from braidx.rods import Rods, Solid, YarnMaterial, straight

LENGTH, SIDE = 100.0, 1.0
MODULUS = 1e3
CELL = rectangle(SIDE, SIDE, degree=2)
LOADS = (1.0, 2.0, 5.0)  # P L^2 / EI
TABLE = np.array([ELASTICA[load] for load in LOADS])


def bar(section, num_elements, poisson=0.0, length=LENGTH, **options):
    """Along x, its directors along y and z."""
    line = straight((0, 0, 0), (length, 0, 0), num_elements * section.degree)
    directors = np.broadcast_to(np.eye(3)[1:], (len(line), 2, 3))
    material = YarnMaterial.isotropic(MODULUS, poisson)
    solid = Solid(line, section.outer_radius, material, section, directors)
    return Rods([solid], **options)


def bending_stiffness(section):
    return MODULUS * section.moments()[1]


def rolled_up(section, num_elements):
    """Largest distance of a section from its place on the circle, over the length."""
    rods = bar(section, num_elements)
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, 2.0 * np.pi * bending_stiffness(section) / LENGTH))
    rods.solve(increments=8)
    s = np.linspace(0.0, LENGTH, rods.layout.num_nodes[0])
    radius = LENGTH / (2.0 * np.pi)
    exact = np.column_stack([circle(s, radius), 0.0 * s])
    return np.abs(rods.positions(0) - exact).max() / LENGTH, rods.q.size


@pytest.mark.parametrize(
    "degree, meshes, order, largest", [(1, (16, 32, 64), 1.8, 0.02), (2, (4, 8, 16), 2.8, 2e-3)]
)
def test_roll_up(record, degree, meshes, order, largest):
    """A bar five hundred times as long as it is thick: strains are small, as the circle assumes."""
    thin = rectangle(0.2 * SIDE, 0.2 * SIDE, (1, 1), degree)
    errors, sizes = zip(*(rolled_up(thin, n) for n in meshes))
    what = f"roll-up of solids, sections, degree {degree}"
    record.converges("V1", what, meshes, errors, order, largest=largest, unknowns=sizes[-1])


def cantilever(slenderness, num_elements):
    """Results as in TABLE."""
    rods, results, before = bar(CELL, num_elements, length=slenderness * SIDE), [], 0.0
    rods.clamp(0, 0)
    length = slenderness * SIDE
    for load in LOADS:
        rods.force(0, -1, (0.0, load * bending_stiffness(CELL) / length**2, 0.0))
        rods.solve(increments=round(load - before))
        results.append(tip_of(rods, length))
        before = load
    return np.array(results), rods.q.size


def test_table(record):
    got, size = cantilever(200.0, 24)
    what = "cantilever of solids, L/d = 200"
    record.check("V2", what, got, TABLE, 2e-4, scale=1.0, unknowns=size)


@pytest.mark.parametrize("slenderness, tolerance", [(10.0, 1e-2), (100.0, 5e-4), (1000.0, 5e-4)])
def test_slenderness(record, slenderness, tolerance):
    got, size = cantilever(slenderness, 16)
    what = f"cantilever of solids, L/d = {slenderness:g}: table of V2"
    record.check("V3", what, got, TABLE, tolerance, scale=1.0, unknowns=size)


def test_curved_cantilever(record):
    """Sections of one cell cannot warp: their torsion constant is the polar moment, as the exact value assumes."""
    line, directors = arc_of_45_degrees(32)
    material = YarnMaterial(1e7, 1e7, 0.5e7)
    rods = Rods([Solid(line, 0.5, material, CELL, directors)])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 0.0, 600.0))
    rods.solve(increments=6)
    moved = rods.positions(0)[-1] - line[-1]
    what, scale = "45 degree arc of solids, load 600: tip", np.linalg.norm(ARC_TIP)
    record.check("V4", what, moved, ARC_TIP, 1e-3, scale=scale, unknowns=rods.q.size)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("stretch", [0.9, 1.1])
def test_uniaxial_tension(record, stretch, poisson):
    section = round_section(1.0, 8)
    rods = bar(section, 4, poisson, length=4.0, tolerance=1e-12)
    rods.pin(0, [0, -1])
    rods.hold(0, 0, [3, 5])  # no spin: g1 of the first section stays along y
    rods.hold(0, -1, [3, 5])
    rods.hold(0, 0, [6])
    rods.hold(0, -1, [6])
    rods.move(0, -1, by=((stretch - 1.0) * 4.0, 0.0, 0.0))
    rods.solve(increments=2)
    force = section.moments()[0] * MODULUS * stretch * (stretch**2 - 1.0) / 2.0
    got = [rods.reaction(0, -1)[0][0], *rods.tension(0)]
    what = f"tension of solids, l = {stretch:g}, nu = 0, 0.3, 0.45"
    record.check("V6", f"{what}: N", got, force, 1e-9, unknowns=rods.q.size)
    width = np.linalg.norm(rods.directors(0), axis=2)
    exact = np.sqrt(1.0 - poisson * (stretch**2 - 1.0))
    record.check("V6", f"{what}: width", width, exact, 1e-9, unknowns=rods.q.size)


@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_torsion(record, poisson):
    """A round section of 16 edges; ends that are held in their planes hinder warping no round bar has."""
    section = round_section(1.0, 16, degree=2, equal_area=True)
    rods, twist = bar(section, 4, poisson, length=4.0), 1e-4
    rods.clamp(0, [0, -1])
    rods.move(0, -1, turn=(twist, 0.0, 0.0))
    rods.solve()
    stiffness = rods.reaction(0, -1)[1][0] * 4.0 / twist
    exact = MODULUS / (2.0 * (1.0 + poisson)) * np.pi / 2.0
    what = f"torsion of solids, nu = {poisson:g}: G pi r^4 / 2"
    record.check("V7", what, stiffness, exact, 2e-3, unknowns=rods.q.size)


@pytest.mark.parametrize("poisson", [0.0, 0.1, 0.2, 0.3, 0.4, 0.45])
def test_bending(record, poisson):
    """Couple over the curvature of the middle half, whose sections deform freely."""
    section = round_section(1.0, 8, degree=2, equal_area=True)
    rods, moment = bar(section, 10, poisson, length=20.0, tolerance=1e-10), 1e-3
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, moment))
    rods.solve()
    first, last = (np.arctan2(-rods.directors(0)[i, 0, 0], 1.0) for i in (5, 15))
    ratio = moment * 10.0 / (last - first) / bending_stiffness(section)
    what = f"bending of solids, nu = {poisson:g}: stiffness over EI"
    record.check("V8", what, ratio, 1.0, 1e-2, unknowns=rods.q.size)
