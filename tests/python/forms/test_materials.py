"""The yarn's law against the inverse of its compliance."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from braidx.forms.materials import (
    Strain,
    TransverselyIsotropic,
    axial_energy,
    section_energy,
    shear_energy,
    stiffness,
)


def compliance(law):
    """Normal compliance in the axes (1, 2, 3), 3 along the yarn; shape (3, 3), 1/MPa."""
    across = law.transverse_poisson / law.transverse_modulus
    along = law.axial_poisson / law.axial_modulus
    return np.array(
        [
            [1.0 / law.transverse_modulus, -across, -along],
            [-across, 1.0 / law.transverse_modulus, -along],
            [-along, -along, 1.0 / law.axial_modulus],
        ]
    )


@given(
    st.floats(1.0, 1e3), st.floats(1.0, 1e3), st.floats(1.0, 1e2), st.floats(0, 0.4), st.integers()
)
def test_energy_is_that_of_the_inverse_compliance(axial, transverse, shear, across, seed):
    ratio = transverse / axial
    along = 0.9 * np.sqrt(0.5 * (1.0 - across) / ratio)
    law = TransverselyIsotropic(axial, transverse, shear, along, across)
    e = np.random.default_rng(abs(seed)).standard_normal(6)
    normal = e[[0, 1, 3]]
    expected = 0.5 * normal @ np.linalg.inv(compliance(law)) @ normal
    expected += transverse / (1.0 + across) * e[2] ** 2 + 2.0 * shear * (e[4] ** 2 + e[5] ** 2)
    strain = Strain(*e)
    energy = axial_energy(strain.e33, law) + section_energy(strain, law) + shear_energy(strain, law)
    assert energy == pytest.approx(expected, rel=1e-9)


def test_isotropic_law_has_the_lame_constants():
    modulus, poisson = 210.0, 0.3
    first = modulus * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    shear = modulus / (2.0 * (1.0 + poisson))
    c = stiffness(TransverselyIsotropic(modulus, modulus, shear, poisson, poisson))
    assert c == pytest.approx((first + 2.0 * shear, first))
