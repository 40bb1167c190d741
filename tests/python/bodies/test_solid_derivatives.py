"""Energy, residual and tangent of solids against finite differences on random states."""

import numpy as np
import pytest
from example_bodies import dense_tangent
from example_solids import CASES, cached_body, random_state
from test_derivatives import differences


@pytest.mark.parametrize("kind, degree, law", CASES)
def test_residual_and_tangent(kind, degree, law):
    body = cached_body(kind, degree, law)
    state = random_state(body)
    expected = differences(body.energy, body, state)
    assert np.linalg.norm(body.residual() - expected) < 1e-7 * np.linalg.norm(expected)
    expected = differences(body.residual, body, state)
    tangent = dense_tangent(body)
    assert np.linalg.norm(tangent - expected) < 1e-7 * np.linalg.norm(expected)
    assert np.abs(tangent - tangent.T).max() < 1e-13 * np.abs(tangent).max()


@pytest.mark.parametrize("kind, degree, law", CASES)
def test_no_zigzag_and_nothing_but_rigid_motion_is_free(kind, degree, law):
    """Six vanishing eigenvalues per part at rest: no hourglass modes."""
    body = cached_body(kind, degree, law)
    body.set_fibre_stress(0.0)
    body.set_state(body.rest)
    values = np.linalg.eigvalsh(dense_tangent(body))
    num_free = 6 * body.mesh.num_parts
    assert np.abs(values[:num_free]).max() < 1e-10 * values[-1]
    assert values[num_free] > 1e-4 * values[-1]
    if kind == "swept" and law == "transversely isotropic":
        body.set_fibre_stress([1.5, 0.0])
