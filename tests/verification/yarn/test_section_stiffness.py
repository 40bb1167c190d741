"""V6 to V9: tension, torsion and bending of one rod, and of a bundle of filaments."""

import numpy as np
import pytest
from single_rod import couple_about_z, equilibrium, straight_rod

from braidx.bodies import BeamSection, YarnMaterial

LENGTH, RADIUS, MODULUS = 4.0, 0.7, 100.0
SECTION = BeamSection.round(RADIUS)
BENDING, TORSION = np.pi * RADIUS**4 / 4.0, np.pi * RADIUS**4 / 2.0


def no_load(node, factor):
    return np.zeros(9), np.zeros((9, 9))


def rod(poisson, degree=1, **options):
    material = YarnMaterial.isotropic(MODULUS, poisson)
    return straight_rod(LENGTH, 4, degree, SECTION, material, **options)


def bending_stiffness(body, moment=1e-4):
    """End couple over curvature, the sections free to deform."""
    q = body.rest
    fixed = np.zeros(q.shape, dtype=bool)
    fixed[0, [0, 1, 2, 3, 5, 6, 7]] = True  # held, but free to stretch: g1 along y, g2 along z
    q = equilibrium(body, couple_about_z(moment), fixed=fixed)
    return moment * LENGTH / np.arctan2(-q[-1, 3], q[-1, 4])


def torsion_stiffness(body, twist=1e-4):
    """End couple over twist rate; sections of both ends are held."""
    start = np.array(body.rest)
    cos, sin = np.cos(twist), np.sin(twist)
    start[-1, 3:] = [0.0, cos, sin, 0.0, -sin, cos]
    fixed = np.zeros(start.shape, dtype=bool)
    fixed[[0, -1]] = True
    q = equilibrium(body, no_load, start=start, fixed=fixed)
    force = body.residual().reshape(q.shape)[-1]
    couple = np.cross(q[-1, 3:6], force[3:6]) + np.cross(q[-1, 6:], force[6:])
    return couple[0] * LENGTH / twist


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("stretch", [0.9, 1.1])
def test_uniaxial_tension(stretch, poisson, degree):
    """V6: N = A E lambda (lambda^2 - 1) / 2, directors of length sqrt(1 - nu (lambda^2 - 1))."""
    body = rod(poisson, degree)
    start = np.array(body.rest)
    start[:, 0] *= stretch
    fixed = np.zeros(start.shape, dtype=bool)
    fixed[[0, -1], :3] = True
    fixed[:, [5, 7]] = True  # no spin about the axis
    fixed[0, 3] = True
    q = equilibrium(body, no_load, start=start, fixed=fixed)
    force = SECTION.area * MODULUS * stretch * (stretch**2 - 1.0) / 2.0
    assert body.residual().reshape(q.shape)[-1, 0] == pytest.approx(force, rel=1e-10)
    assert body.tension(q) == pytest.approx(np.full(4, force), rel=1e-10)
    length = np.sqrt(1.0 - poisson * (stretch**2 - 1.0))
    for director in (q[:, 3:6], q[:, 6:]):
        assert np.linalg.norm(director, axis=1) == pytest.approx(np.full(len(q), length))


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_torsion(poisson, degree):
    """V7: the couple is G pi r^4 / 2 times the twist rate."""
    shear_modulus = MODULUS / (2.0 * (1.0 + poisson))
    stiffness = torsion_stiffness(rod(poisson, degree))
    assert stiffness == pytest.approx(shear_modulus * TORSION, rel=1e-6)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.1, 0.2, 0.3, 0.4, 0.45])
def test_bending(poisson, degree):
    """V8: the couple is EI times the curvature, whatever the Poisson ratio."""
    ratio = bending_stiffness(rod(poisson, degree)) / (MODULUS * BENDING)
    assert ratio == pytest.approx(1.0, rel=1e-6)


@pytest.mark.parametrize("filaments", [10, 1000])
def test_bundle(filaments):
    """V9: n filaments that slide freely have 1 / n of the solid rod's bending and torsion."""
    bundle = rod(0.3, bundle_factor=1.0 / filaments)
    moment = 1e-4 / filaments
    solid = bending_stiffness(rod(0.3)), torsion_stiffness(rod(0.3))
    assert bending_stiffness(bundle, moment) == pytest.approx(solid[0] / filaments, rel=1e-6)
    assert torsion_stiffness(bundle) == pytest.approx(solid[1] / filaments, rel=1e-6)


def test_factors_are_separate():
    """The factor on torsion is an input of its own."""
    body = rod(0.0, bundle_factor=0.1, torsion_factor=0.5)
    assert bending_stiffness(body, 1e-5) == pytest.approx(0.1 * MODULUS * BENDING, rel=1e-6)
    assert torsion_stiffness(body) == pytest.approx(0.25 * MODULUS * TORSION, rel=1e-6)
