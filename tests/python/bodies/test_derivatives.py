"""Energy, residual and tangent of each model against finite differences on random states."""

import numpy as np
import pytest
from example_bodies import cached_body, dense_tangent, random_state

MODELS = ("cable", "beam", "straight beam", "tense beam", "linear beam")
CASES = [(model, degree) for model in MODELS for degree in (1, 2)]
STEP = 1e-5


def differences(function, body, state):
    """Central differences of `function` of the body by each unknown, one row each."""
    rows = []
    for i in range(state.size):
        values = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            moved.flat[i] += sign * STEP
            body.set_state(moved)
            values.append(np.copy(function()))
        rows.append((values[0] - values[1]) / (2.0 * STEP))
    body.set_state(state)
    return np.array(rows)


@pytest.mark.parametrize("model, degree", CASES)
def test_residual_is_the_gradient_of_the_energy(model, degree):
    body = cached_body(model, degree)
    expected = differences(body.energy, body, random_state(body))
    error = np.linalg.norm(body.residual() - expected)
    assert error < 1e-8 * np.linalg.norm(expected)


@pytest.mark.parametrize("model, degree", CASES)
def test_tangent_is_the_derivative_of_the_residual(model, degree):
    body = cached_body(model, degree)
    expected = differences(body.residual, body, random_state(body))
    tangent = dense_tangent(body)
    assert np.linalg.norm(tangent - expected) < 1e-8 * np.linalg.norm(expected)
    assert np.abs(tangent - tangent.T).max() < 1e-13 * np.abs(tangent).max()


@pytest.mark.parametrize("model, degree", CASES)
def test_storage_is_reused_and_repeatable(model, degree):
    body = cached_body(model, degree)
    body.set_state(random_state(body))
    residual, tangent = body.residual(), body.tangent_values()
    first = residual.copy(), tangent.copy()
    body.set_state(random_state(body, seed=1))
    assert not np.allclose(body.residual(), first[0])
    body.set_state(random_state(body))
    assert np.array_equal(body.residual(), first[0])
    assert np.array_equal(body.tangent_values(), first[1])
    assert np.shares_memory(body.tangent_values(), tangent)
    rows, columns = body.tangent_pattern()
    assert len(set(zip(rows.tolist(), columns.tolist()))) == len(rows) == len(tangent)
