"""V6 to V9: tension, torsion and bending of one rod, and of a bundle of filaments (exact)."""

import numpy as np
import pytest

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial, straight

LENGTH, RADIUS, MODULUS = 4.0, 0.7, 100.0
SECTION = BeamSection.round(RADIUS)
BENDING, TORSION = np.pi * RADIUS**4 / 4.0, np.pi * RADIUS**4 / 2.0
LAW = "N = A E l (l^2 - 1) / 2"


def rod(poisson, degree=1, **factors):
    """Along x, its directors along y and z."""
    line = straight((0, 0, 0), (LENGTH, 0, 0), 4 * degree)
    material = YarnMaterial.isotropic(MODULUS, poisson)
    return Rods([Beam(line, RADIUS, material, degree=degree, **factors)], tolerance=1e-12)


def bending_stiffness(rods, moment=1e-4):
    """End couple over curvature, the sections free to deform."""
    rods.hold(0, 0, [0, 1, 2, 3, 5, 6, 7])  # held, but free to stretch
    rods.couple(0, -1, (0.0, 0.0, moment))
    rods.solve()
    x, y, _ = rods.directors(0)[-1, 0]
    return moment * LENGTH / np.arctan2(-x, y)


def torsion_stiffness(rods, twist=1e-4):
    """End couple over twist rate; sections of both ends are held."""
    rods.clamp(0, [0, -1])
    rods.move(0, -1, turn=(twist, 0.0, 0.0))
    rods.solve()
    return rods.reaction(0, -1)[1][0] * LENGTH / twist


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("stretch", [0.9, 1.1])
def test_uniaxial_tension(record, stretch, poisson, degree):
    """V6: N = A E lambda (lambda^2 - 1) / 2, directors of length sqrt(1 - nu (lambda^2 - 1))."""
    rods = rod(poisson, degree)
    rods.pin(0, [0, -1])
    rods.hold(0, components=[5, 7])  # no spin about the axis
    rods.hold(0, 0, [3])
    rods.move(0, -1, by=((stretch - 1.0) * LENGTH, 0.0, 0.0))
    even = rods.q.reshape(-1, 9).copy()
    even[:, 0] *= stretch
    rods.solve(guess=even.ravel())  # the straight rod, which would buckle too
    force = SECTION.area * MODULUS * stretch * (stretch**2 - 1.0) / 2.0
    got = [rods.reaction(0, -1)[0][0], *rods.tension(0)]
    unknowns = rods.q.size
    what = f"tension, l = {stretch:g}, nu = 0, 0.3, 0.45: {LAW}"
    record.check("V6", what, got, force, 1e-10, unknowns=unknowns)
    length = np.sqrt(1.0 - poisson * (stretch**2 - 1.0))
    what = f"tension, l = {stretch:g}: length of the directors"
    free = np.linalg.norm(rods.directors(0), axis=2)
    record.check("V6", what, free, length, 1e-6, unknowns=unknowns)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_torsion(record, poisson, degree):
    """V7: the couple is G pi r^4 / 2 times the twist rate."""
    rods = rod(poisson, degree)
    shear_modulus = MODULUS / (2.0 * (1.0 + poisson))
    got = torsion_stiffness(rods)
    what = f"torsion, nu = {poisson:g}: G pi r^4 / 2"
    record.check("V7", what, got, shear_modulus * TORSION, 1e-6, unknowns=rods.q.size)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.1, 0.2, 0.3, 0.4, 0.45])
def test_bending(record, poisson, degree):
    """V8: the couple is EI times the curvature, whatever the Poisson ratio."""
    rods = rod(poisson, degree)
    ratio = bending_stiffness(rods) / (MODULUS * BENDING)
    what = f"bending, nu = {poisson:g}: stiffness over EI"
    record.check("V8", what, ratio, 1.0, 1e-6, unknowns=rods.q.size)


@pytest.mark.parametrize("filaments", [10, 1000])
def test_bundle(record, filaments):
    """V9: n filaments that slide freely have 1 / n of the solid rod's bending and torsion."""

    def bundle():
        return rod(0.3, bundle_factor=1.0 / filaments)

    bent, twisted = bending_stiffness(rod(0.3)), torsion_stiffness(rod(0.3))
    ratio = bending_stiffness(bundle(), 1e-4 / filaments) / bent
    what = f"bundle of {filaments} over the solid rod"
    record.check("V9", f"{what}: bending", ratio, 1.0 / filaments, 1e-6)
    ratio = torsion_stiffness(bundle()) / twisted
    record.check("V9", f"{what}: torsion", ratio, 1.0 / filaments, 1e-6)


def test_factors_are_separate():
    """The factor on torsion is an input of its own."""
    factors = {"bundle_factor": 0.1, "torsion_factor": 0.5}
    bent, twisted = bending_stiffness(rod(0.0, **factors), 1e-5), torsion_stiffness(
        rod(0.0, **factors)
    )
    assert bent == pytest.approx(0.1 * MODULUS * BENDING, rel=1e-6)
    assert twisted == pytest.approx(0.25 * MODULUS * TORSION, rel=1e-6)
