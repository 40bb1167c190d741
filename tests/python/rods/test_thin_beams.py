"""Beams of few elements bend as thin rods do, whatever they contract by when pulled."""

import numpy as np
import pytest

from braidx.rods import Beam, Rods, YarnMaterial, straight

LENGTH, MODULUS = 1000.0, 1000.0  # mm, MPa


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.49])
@pytest.mark.parametrize("slenderness", [1e2, 1e4])
def test_deflection_of_a_cantilever_of_eight_elements(poisson: float, slenderness: float) -> None:
    # P L^2 / EI = 1 (Mattiasson 1981); elements of 125 radii of degree 2 deflected by half of it for nu = 0.3.
    radius = LENGTH / slenderness
    bending = MODULUS * np.pi * radius**4 / 4.0
    line = straight((0, 0, 0), (LENGTH, 0, 0), 16)
    rods = Rods([Beam(line, radius, YarnMaterial.isotropic(MODULUS, poisson))])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, bending / LENGTH**2, 0.0))
    rods.solve(3)
    assert rods.positions(0)[-1, 1] / LENGTH == pytest.approx(0.3017208, rel=1e-3)


@pytest.mark.parametrize("slenderness", [1e3, 1e5])
def test_thin_beams_are_bent_in_a_few_iterations(slenderness: float) -> None:
    # P L^2 / EI = 10. With the stresses of the current state in the tangent it took 15 to 170 per increment, and cuts.
    radius = LENGTH / slenderness
    bending = MODULUS * np.pi * radius**4 / 4.0
    line = straight((0, 0, 0), (LENGTH, 0, 0), 64)
    rods = Rods([Beam(line, radius, YarnMaterial.isotropic(MODULUS, 0.3))])
    rods.clamp(0, 0)
    rods.force(0, -1, (0.0, 10.0 * bending / LENGTH**2, 0.0))
    done = rods.solve(10)
    assert len(done) == 10 and max(increment.iterations for increment in done) <= 10
    assert rods.positions(0)[-1, 1] / LENGTH == pytest.approx(0.8106090, rel=1e-5)
