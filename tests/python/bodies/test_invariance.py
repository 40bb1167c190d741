"""Superposed rigid motion changes no internal force (verification V11, bodies alone)."""

import numpy as np
import pytest
from example_bodies import cached_body, random_state
from scipy.spatial.transform import Rotation


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("model", ["cable", "beam", "linear beam"])
def test_rigid_motion(model, degree):
    body = cached_body(model, degree)
    state = random_state(body)
    rotation = Rotation.from_rotvec([0.7, -2.1, 1.3]).as_matrix()
    moved = (state.reshape(body.num_nodes, -1, 3) @ rotation.T).reshape(state.shape)
    moved[:, :3] += [3.0, -2.0, 5.0]

    body.set_state(state)
    energy, force = body.energy(), body.residual().copy()
    turned = (force.reshape(-1, 3) @ rotation.T).ravel()
    body.set_state(moved)
    assert body.energy() == pytest.approx(energy, rel=1e-12)
    assert np.abs(body.residual() - turned).max() < 1e-12 * np.abs(turned).max()
    assert body.tension(moved) == pytest.approx(body.tension(state), rel=1e-11)


@pytest.mark.parametrize("degree", [1, 2])
@pytest.mark.parametrize("model", ["cable", "beam", "linear beam"])
def test_internal_forces_are_in_equilibrium(model, degree):
    body = cached_body(model, degree)
    state = random_state(body)
    body.set_state(state)
    force = body.residual().reshape(body.num_nodes, -1, 3)
    moment = np.cross(state.reshape(force.shape), force).sum(axis=(0, 1))
    size = np.abs(force).max()
    assert np.abs(force[:, 0].sum(axis=0)).max() < 1e-12 * size
    assert np.abs(moment).max() < 1e-12 * size * np.abs(state).max()
