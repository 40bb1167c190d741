"""Beams: rest, natural state, change of properties and of the reference."""

import numpy as np
import pytest
from example_bodies import (
    MATERIALS,
    SECTIONS,
    cached_body,
    centre_lines,
    dense_tangent,
    make_body,
    random_state,
)
from mpi4py import MPI

from braidx.bodies import BeamBody, BeamSection, YarnMaterial


@pytest.mark.parametrize("degree", [1, 2])
def test_as_placed_is_free_of_stress(degree):
    body = cached_body("beam", degree)
    body.set_state(body.rest)
    assert np.abs(body.residual()).max() < 1e-12
    assert np.abs(body.tension(body.rest)).max() < 1e-12


@pytest.mark.parametrize("degree", [1, 2])
def test_only_rigid_motion_is_free(degree):
    """Six zero eigenvalues per curve, all others positive: no spurious modes."""
    body = cached_body("beam", degree)
    body.set_state(body.rest)
    values = np.linalg.eigvalsh(dense_tangent(body)) / np.abs(dense_tangent(body)).max()
    assert np.abs(values[:12]).max() < 1e-12
    assert values[12] > 1e-7


def test_straight_stores_the_energy_of_bending():
    """A fine helix of round section stores 1/2 beta E I kappa^2 per length, and no torsion."""
    line = np.stack(
        [3.0 * np.cos(a := np.linspace(0, 2 * np.pi, 161)), 3.0 * np.sin(a), 12.0 * a / 2 / np.pi],
        axis=1,
    )
    body = BeamBody(
        MPI.COMM_SELF,
        [line],
        section=SECTIONS[0],
        material=MATERIALS[0],
        bundle_factor=0.5,
        natural_state="straight",
    )
    curvature = 3.0 / (9.0 + (12.0 / (2.0 * np.pi)) ** 2)
    stiffness = 0.5 * MATERIALS[0].axial_modulus * SECTIONS[0].inertia_1
    expected = 0.5 * stiffness * curvature**2 * body.rest_lengths().sum()
    assert body.energy() == pytest.approx(expected, rel=2e-3)
    body.set_properties(natural_state="as placed")
    assert body.energy() == pytest.approx(0.0, abs=1e-20)


def test_new_properties_equal_a_new_body():
    body, other = make_body("beam", 1), cached_body("straight beam", 1)
    body.set_properties(
        section=SECTIONS[1],
        material=MATERIALS[1],
        bundle_factor=0.1,
        torsion_factor=0.7,
        natural_state="straight",
    )
    state = random_state(body)
    body.set_state(state)
    assert not np.allclose(body.residual(), other.residual())
    body.set_properties(
        section=SECTIONS, material=MATERIALS, bundle_factor=[0.05, 0.6], torsion_factor=0.3
    )
    other.set_state(state)
    assert body.residual() == pytest.approx(other.residual())
    assert body.axial_stress(state) == pytest.approx(other.axial_stress(state))


@pytest.mark.parametrize("degree", [1, 2])
def test_the_reference_may_be_under_tension(degree):
    body = make_body("tense beam", degree)
    first, second = np.split(body.tension(body.rest), body.layout.curve_elements[1:-1])
    assert first == pytest.approx(2.0) and second == pytest.approx(3.0)
    stretched = body.rest.copy()
    stretched[:, :3] *= 1.001
    assert np.all(body.tension(stretched) > body.tension(body.rest))


@pytest.mark.parametrize("degree", [1, 2])
def test_new_reference(degree):
    body = make_body("beam", degree)
    state = random_state(body)
    body.set_reference(state)
    body.set_state(state)
    assert np.abs(body.residual()).max() < 1e-12
    assert body.rest is not state and np.array_equal(body.rest, state)


def test_bad_input_is_named():
    def beam(**changes):
        options = {"section": SECTIONS[0], "material": MATERIALS[0]} | changes
        return BeamBody(MPI.COMM_SELF, centre_lines(), **options)

    with pytest.raises(ValueError, match="bundle_factor"):
        beam(bundle_factor=0.0)
    with pytest.raises(ValueError, match="natural_state"):
        beam(natural_state="curly")
    with pytest.raises(ValueError, match="section has 3 items"):
        beam(section=[SECTIONS[0]] * 3)
    with pytest.raises(ValueError, match="area"):
        BeamSection(-1.0, 1.0, 1.0, 1.0, 1.0)
    with pytest.raises(ValueError, match="axial_poisson"):
        YarnMaterial(1.0, 1.0, 1.0, 0.8, 0.3)
    with pytest.raises(ValueError, match="transverse_modulus"):
        YarnMaterial(1.0, 0.0, 1.0)
