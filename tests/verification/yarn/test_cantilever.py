"""V2 and V3: cantilever under a dead tip load, and the same at growing slenderness."""

import numpy as np
import pytest
from single_rod import dead_force, equilibrium, straight_rod

from braidx.bodies import BeamSection, YarnMaterial

# Load P L^2 / EI: shortening / L, deflection / L, angle of the tip (exact, inextensible).
EXACT = {
    1.0: (0.0564332, 0.3017208, 0.4613519),
    2.0: (0.1606417, 0.4934575, 0.7817498),
    5.0: (0.3876284, 0.7137915, 1.2153681),
    10.0: (0.5549956, 0.8106090, 1.4302855),
}


def tip(body):
    """Shortening, deflection and angle of the tip at the tabulated loads; length and EI are 1."""
    results = []

    def observe(q):
        results.append((1.0 - q[-1, 0], q[-1, 1], np.arctan2(-q[-1, 3], q[-1, 4])))

    loads = np.arange(0.5, 10.1, 0.5)
    equilibrium(body, dead_force([0.0, 1.0, 0.0]), steps=loads, observe=observe)
    return np.array([results[np.flatnonzero(np.isclose(loads, load))[0]] for load in EXACT])


def largest_error(body):
    return np.abs(tip(body) - np.array(list(EXACT.values()))).max()


def shear_rigid(num_elements, degree):
    section = BeamSection(1e8, 1.0, 1.0, 2.0, 1e8)
    return straight_rod(1.0, num_elements, degree, section, YarnMaterial(1.0, 1.0, 0.5))


def slender(slenderness, num_elements, degree=2):
    """Round rod of diameter 1 / slenderness, EI = 1, nu = 0."""
    section = BeamSection.round(0.5 / slenderness)
    modulus = 1.0 / section.inertia_1
    material = YarnMaterial.isotropic(modulus, 0.0)
    return straight_rod(1.0, num_elements, degree, section, material)


def test_table():
    assert largest_error(shear_rigid(16, 2)) < 5e-6


def test_order_of_degree_1():
    errors = [largest_error(shear_rigid(n, 1)) for n in (8, 16)]
    assert errors[0] / errors[1] > 3.5


@pytest.mark.parametrize("slenderness, tolerance", [(1e1, 1e-2), (1e2, 1e-4), (1e3, 5e-6)])
def test_slenderness(slenderness, tolerance):
    """The deviation is that of the extensible, shear-soft rod, of the order of (d / L)^2."""
    assert largest_error(slender(slenderness, 16)) < tolerance


def test_no_shear_locking():
    """One in ten thousand: the same mesh gives the same error as the shear-rigid rod."""
    assert largest_error(slender(1e4, 16)) < 5e-6
    assert largest_error(slender(1e4, 8)) < 1e-4
