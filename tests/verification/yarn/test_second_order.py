"""What twist and bending do to the length of a round rod, of second order in radius times rate.

Twisted by psi with no force along it, fibres at the distance rho are stretched by rho^2 psi^2 / 2, r^2 psi^2 / 4 in the
mean, and the rod is shortened by as much. Shear draws the sections together, too, by which a rod of Poisson ratio nu
gets longer: the mean strain of its fibres is 2 nu / (1 + nu) r^2 psi^2 / 4. What is left of the shortening is the share
(1 - nu) / (1 + nu). Bent by kappa, fibres of Saint-Venant's and Kirchhoff's law are softer where they are compressed:
the axis is shortened by 3/2 I / A kappa^2. That of fibres whose force is linear in their stretch keeps its length.
"""

import numpy as np
import pytest

from braidx.rods import Beam, Rods, Solid, YarnMaterial, arc, straight

RADIUS, LENGTH, MODULUS, RATE = 1.0, 4.0, 1000.0, 0.1  # mm, mm, MPa, radians per radius
AREA, INERTIA = np.pi * RADIUS**2, np.pi * RADIUS**4 / 4.0
SVK, LINEAR = "Saint-Venant-Kirchhoff", "linear"


def rod(model, poisson, degree=2, law=SVK):
    """Along x, free to stretch along and across."""
    line = straight((0, 0, 0), (LENGTH, 0, 0), 4 * degree if model is Beam else 4)
    options = {"axial_law": law, "degree": degree} if model is Beam else {"seeds": 8}
    material = YarnMaterial.isotropic(MODULUS, poisson)
    rods = Rods([model(line, RADIUS, material, **options)], tolerance=1e-9)
    rods.hold(0, 0, [0, 1, 2, 3, 5, 6, 7])
    return rods


def twisted(model, poisson, **options):
    """Strain of the axis over r^2 psi^2 / 4, and the couple over G J psi."""
    rods = rod(model, poisson, **options)
    shear = MODULUS / (2.0 * (1.0 + poisson))
    couple = shear * 2.0 * INERTIA * RATE
    rods.couple(0, -1, (couple, 0.0, 0.0))
    rods.solve()
    _, y, z = rods.directors(0)[-1, 0]
    rate = np.arctan2(z, y) / LENGTH
    strain = rods.positions(0)[-1, 0] / LENGTH - 1.0
    return strain / (rate**2 / 4.0), couple / (shear * 2.0 * INERTIA * rate)


def bent(model, poisson, **options):
    """Strain of the axis over I / A kappa^2."""
    rods = rod(model, poisson, **options)
    rods.couple(0, -1, (0.0, 0.0, MODULUS * INERTIA * RATE))
    rods.solve()
    x, y, _ = rods.directors(0)[-1, 0]
    angle = np.arctan2(-x, y)
    chord = np.linalg.norm(rods.positions(0)[-1])
    length = chord * angle / (2.0 * np.sin(angle / 2.0))
    return (length / LENGTH - 1.0) / (INERTIA / AREA * (angle / LENGTH) ** 2)


@pytest.mark.parametrize("law", [SVK, LINEAR])
@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_a_twisted_beam_is_shortened_by_the_stretch_of_its_fibres(poisson, degree, law):
    share = (1.0 - poisson) / (1.0 + poisson)
    strain, _ = twisted(Beam, poisson, degree=degree, law=law)
    assert strain == pytest.approx(-share, abs=0.01)


@pytest.mark.parametrize("law, share", [(SVK, 1.5), (LINEAR, 0.0)])
def test_a_bent_beam_is_shortened_by_its_law(law, share):
    assert bent(Beam, 0.0, law=law) == pytest.approx(-share, abs=0.015)


@pytest.mark.parametrize("poisson", [0.0, 0.3])
def test_twisted_beam_and_solid_are_one(poisson):
    beam, solid = twisted(Beam, poisson), twisted(Solid, poisson)
    assert beam[0] == pytest.approx(solid[0], abs=0.01)
    assert beam[1] == pytest.approx(solid[1], rel=0.004)  # fourth order: (E / G) r^2 psi^2 / 12


def test_bent_beam_and_solid_are_one():
    """For nu = 0; with nu = 0.3 sections of solids bend too: 1.30 where the beam has 1.20."""
    assert bent(Beam, 0.0) == pytest.approx(bent(Solid, 0.0), abs=0.01)


@pytest.mark.parametrize("law", [SVK, LINEAR])
def test_a_thick_arc_couples_bending_and_stretch_as_a_curved_bar_does(law):
    """Winkler's bar of radius R, to second order in r / R.

    Its energy per length is 1/2 E (A e^2 + I (c - e / R)^2) with the strain e of the axis and the rate c of rotation. A
    couple M at the end of a quarter of a ring makes e = M / (E A R) and c = M / E (1 / I + 1 / (A R^2)). That end moves
    by c R^2 (-1, pi / 2 - 1) + e R (1, 1).
    """
    radius, couple = 5.0, 1e-5 * MODULUS * INERTIA
    material = YarnMaterial(MODULUS, 1e4 * MODULUS, MODULUS / 2.0)  # sections do not deform
    beam = Beam(arc(radius, np.pi / 2, 64), RADIUS, material, axial_law=law)
    rods = Rods([beam], tolerance=1e-10)
    before = rods.positions(0)[-1].copy()
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, couple))
    rods.solve()
    strain = couple / (MODULUS * AREA * radius)
    rate = couple / MODULUS * (1.0 / INERTIA + 1.0 / (AREA * radius**2))
    expected = rate * radius**2 * np.array([-1.0, np.pi / 2 - 1.0, 0.0])
    expected += strain * radius * np.array([1.0, 1.0, 0.0])
    size = np.linalg.norm(expected)  # of which e alone is 1 %
    assert rods.positions(0)[-1] - before == pytest.approx(expected, abs=5e-4 * size)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("stretch", [0.9, 1.01, 1.1])
def test_linear_law_in_tension(stretch, degree):
    """N = E A (l - 1); the 1.5 % that Saint-Venant's and Kirchhoff's has more at 1 % of strain are not there."""
    rods = rod(Beam, 0.3, degree, LINEAR)
    rods.hold(0, -1, [0, 1, 2])
    rods.hold(0, components=[5, 7])
    rods.move(0, -1, by=((stretch - 1.0) * LENGTH, 0.0, 0.0))
    even = rods.q.reshape(-1, 9) * [stretch, 1, 1, 1, 1, 1, 1, 1, 1]
    rods.solve(guess=even.ravel())
    force = AREA * MODULUS * (stretch - 1.0)
    assert rods.reaction(0, -1)[0][0] == pytest.approx(force, rel=1e-9)
    assert rods.tension(0) == pytest.approx(np.full(4, force), rel=1e-9)


def test_thin_beams_of_the_linear_law_bend_in_a_few_iterations():
    """P L^2 / EI = 10 at a slenderness of 1e4, as with the other law."""
    length, radius = 1000.0, 0.1
    stiffness = MODULUS * np.pi * radius**4 / 4.0
    line = straight((0, 0, 0), (length, 0, 0), 64)
    material = YarnMaterial.isotropic(MODULUS, 0.3)
    rods = Rods([Beam(line, radius, material, axial_law=LINEAR)])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 10.0 * stiffness / length**2, 0.0))
    done = rods.solve(10)
    assert len(done) == 10 and max(increment.iterations for increment in done) <= 10
    assert rods.positions(0)[-1, 1] / length == pytest.approx(0.8106090, rel=1e-5)
