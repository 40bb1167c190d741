"""Planes of symmetry, plane strain, holds inside solids, graded lines: against the whole, and beam theory."""

import numpy as np
import pytest

from braidx.meshing import rectangle
from braidx.rods import Beam, Cable, Plane, Rods, Solid, YarnMaterial, graded, straight

MODULUS, POISSON, RADIUS = 1e3, 0.3, 0.5
SOFT = YarnMaterial.isotropic(MODULUS, POISSON)


def whole_and_half(model):
    """Clamped at its ends, which are x = -8 and 8; the half ends at the plane x = 0."""
    whole = Rods([model(straight((-8, 0, 0), (8, 0, 0), 8), RADIUS, SOFT)])
    whole.clamp(0, [0, -1])
    half = Rods([model(straight((-8, 0, 0), (0, 0, 0), 4), RADIUS, SOFT)])
    half.clamp(0, 0)
    half.symmetry(0)
    return whole, half


def test_half_of_a_bent_beam_is_half_of_the_whole():
    whole, half = whole_and_half(Beam)
    for rods in (whole, half):
        rods.line_load(0, (0.0, -0.025, 0.0))
        rods.solve()
    assert half.positions(0) == pytest.approx(whole.positions(0)[:5], abs=1e-7)
    force = half.reaction(0, 0)[0]
    assert force[1] == pytest.approx(0.2, rel=1e-6)
    assert half.reaction(0, -1)[0] == pytest.approx([-force[0], 0.0, 0.0], abs=1e-6)


def test_half_of_a_stretched_solid_is_half_of_the_whole():
    whole, half = whole_and_half(Solid)
    whole.move(0, -1, by=(0.2, 0.0, 0.0))
    for rods in (whole, half):
        rods.move(0, 0, by=(-0.2, 0.0, 0.0))
        rods.solve()
    assert half.positions(0) == pytest.approx(whole.positions(0)[:5], abs=1e-4)
    pulls = [rods.reaction(0, 0)[0][0] for rods in (half, whole)]
    assert pulls[0] == pytest.approx(pulls[1], rel=1e-3)
    assert half.reaction(0, -1)[0][0] == pytest.approx(-pulls[0], rel=1e-6)


def test_a_cable_in_a_plane_and_across_another():
    """A quarter of a net: two cables through its middle, crossing, under a weight there."""
    rods = Rods([Cable(straight((-9, 0, 0), (0, 0, 0), 2), 0.1, 1e4, tension=20.0)])
    rods.pin(0, 0)
    rods.symmetry(0)
    rods.symmetry(1)
    rods.force(0, -1, (0.0, 0.0, -1.0))
    rods.solve()
    ends = rods.positions(0)[[0, -1]]
    sine = -(ends[1] - ends[0])[2] / np.linalg.norm(ends[1] - ends[0])
    assert rods.tension(0)[0] * sine == pytest.approx(1.0, rel=1e-5)
    assert rods.positions(0)[:, 1] == pytest.approx(np.zeros(3), abs=1e-12)


def test_a_plane_stands_for_the_image_in_contact():
    """Two parallel beams pressed together, and one pressed on the plane between them."""
    lines = [straight((0, 0, z), (6, 0, z), 4) for z in (0.5, -0.5)]
    pair = Rods([Beam(x, RADIUS, SOFT) for x in lines])
    one = Rods([Beam(lines[0], RADIUS, SOFT)], rigid=[Plane((0, 0, 0), (0, 0, 1))])
    for rods in (pair, one):
        rods.hold(0, slice(None), [0, 1])
        rods.line_load(0, (0.0, 0.0, -0.2))
    pair.hold(1, slice(None), [0, 1])
    pair.line_load(1, (0.0, 0.0, 0.2))
    pair.hold_mean([(0, 2), (1, 2)], [2])
    for rods in (pair, one):
        rods.solve()
    sums = [np.sum(rods.contacts()["normal_force"]) for rods in (pair, one)]
    assert sums == pytest.approx([1.2, 1.2], rel=1e-4)
    assert one.positions(0)[2, 2] == pytest.approx(pair.positions(0)[2, 2], abs=0.01 * RADIUS)


def strip(free):
    """A strip, 2 x 1, pulled along x, free to contract along z or not; it may contract along y."""
    line = straight((0, 0, 0), (8, 0, 0), 4)
    section = rectangle(2.0, 1.0, (2, 1), degree=2)
    axes = np.tile([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], (5, 1, 1))
    rods = Rods([Solid(line, 0.5, SOFT, section=section, directors=axes)])
    rods.hold(0, 0, [0, 1, 2, 3, 6, 5, 7])
    rods.hold(0, -1, [1, 2, 3, 6, 5, 7])
    if not free:
        rods.plane_strain(0)
    load = 0.02
    rods.force(0, -1, (load, 0.0, 0.0))
    rods.solve()
    strain = rods.positions(0)[-1, 0] / 8.0 - 1.0
    return load / 2.0 / strain


def test_plane_strain_is_stiffer():
    """E without, E / (1 - nu^2) with plane strain (exact at small strains)."""
    assert strip(True) == pytest.approx(MODULUS, rel=1e-3)
    assert strip(False) == pytest.approx(MODULUS / (1.0 - POISSON**2), rel=1e-3)


def test_holds_inside_a_solid_carry_its_load():
    """Nodes in a box in the middle of a bar hold it: its halves stretch and shorten as bars do."""
    rods = Rods([Solid(straight((0, 0, 0), (12, 0, 0), 12), RADIUS, SOFT)])
    rods.hold_inside(0, [(5.9, -1, -1), (6.1, 1, 1)])
    rods.force(0, -1, (0.1, 0.0, 0.0))
    rods.solve()
    x = rods.positions(0)[:, 0]
    assert x[:7] == pytest.approx(np.arange(7.0), abs=1e-6)
    area = rods.rods[0].area
    # Half a radius or so at the held section cannot contract.
    assert x[-1] - 12.0 == pytest.approx(0.1 * 6.0 / (MODULUS * area), rel=0.03)


def test_graded_lines():
    line = graded((0, 0, 0), (7, 0, 0), 6, 4.0)
    assert np.diff(line[:, 0]) == pytest.approx([0.5, 0.5, 1, 1, 2, 2])
    beam = Beam(graded((0, 0, 0), (40, 0, 0), 12, 8.0), RADIUS, SOFT)
    rods = Rods([beam])
    rods.clamp(0, 0)
    load, bending = 1e-5, MODULUS * np.pi * RADIUS**4 / 4.0
    rods.force(0, -1, (0.0, load, 0.0))
    rods.solve()
    assert rods.positions(0)[-1, 1] == pytest.approx(load * 40.0**3 / 3.0 / bending, rel=2e-3)


def test_bad_planes_and_places_are_named():
    rods = Rods([Beam(straight((0, 0, 0), (6, 0, 0), 4), RADIUS, SOFT)])
    with pytest.raises(ValueError, match="axis is 3: give 0, 1 or 2"):
        rods.symmetry(3)
    with pytest.raises(ValueError, match="no node is on the plane at 9.0 mm"):
        rods.symmetry(0, 9.0)
    with pytest.raises(ValueError, match="rod 0 is no Solid"):
        rods.hold_inside(0, [(0, 0, 0), (1, 1, 1)])
    turned = np.tile([[0.0, 0.8, 0.6], [0.0, -0.6, 0.8]], (5, 1, 1))
    aslant = Rods([Beam(straight((0, 0, 0), (6, 0, 0), 4), RADIUS, SOFT, directors=turned)])
    with pytest.raises(ValueError, match="a director of rod 0 is .*: give `directors`"):
        aslant.symmetry(1)
    solid = Rods([Solid(straight((0, 0, 0), (6, 0, 0), 4), RADIUS, SOFT)])
    with pytest.raises(ValueError, match="where names no node of rod 0: they lie between"):
        solid.hold_inside(0, [(9, 9, 9), (10, 10, 10)])
    with pytest.raises(ValueError, match=r"where has shape \(3,\): give \(2, 3\)"):
        solid.hold_inside(0, (1, 2, 3))
    with pytest.raises(ValueError, match="ratio is -1"):
        graded((0, 0, 0), (1, 0, 0), 4, -1)
    with pytest.raises(ValueError, match="num_spans is 5: elements of degree 2 take 2 each"):
        graded((0, 0, 0), (1, 0, 0), 5, 2.0)
