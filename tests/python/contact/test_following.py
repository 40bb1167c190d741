"""Contact of curved yarns that cross: sections and normals follow the yarns, the tangent knows of it."""

import numpy as np
import pytest
import scipy.sparse as sp
from mpi4py import MPI
from scipy.spatial.transform import Rotation

from braidx.contact.contact import Contact
from braidx.contact.tubes import TubeLayout

RADIUS, NODES = 1.0, 15
POINT = np.iinfo(np.int64).max


def arcs(angle):
    """Two arcs that cross at an angle (degrees) and press on each other; nodes, shape (2, NODES, 3), mm."""
    along = np.linspace(-6.0, 6.0, NODES)
    bow = 0.02 * along**2
    turn = np.radians(angle) / 2
    lines = []
    for sign in (-1, 1):
        across, up = np.sin(sign * turn) * along, np.cos(turn) * along
        lines.append(np.stack([sign * (0.97 * RADIUS + bow), across + 0.13 * sign, up], axis=1))
    return np.array(lines)


def contact_at(angle, block, friction=0.0, seed=0):
    """Contact and unknowns, shaken so that nothing is symmetric, after a step of sliding."""
    rng = np.random.default_rng(seed)
    positions = arcs(angle).reshape(-1, 3)
    frames = np.broadcast_to([1.0, 0, 0, 0, 1.0, 0], (len(positions), 6))[:, : block - 3]
    q = np.hstack([positions, frames])
    q += 0.01 * rng.standard_normal(q.shape)
    ones = np.ones(2)
    layout = TubeLayout(
        first_unknown=np.array([0, NODES * block]),
        num_elements=(NODES - 1) * ones,
        degree=ones,
        block=block * ones,
        radius=RADIUS * ones,
        element_length=12.0 / (NODES - 1) * ones,
        body=0 * ones,
    )
    contact = Contact(MPI.COMM_SELF, layout, smooth=True, symmetric=False)
    contact.pairing.spacing = 0.4
    contact.laws.friction = [friction]
    contact.start = (q - 0.02 * rng.standard_normal(q.shape)).ravel()
    contact.update(q.ravel())
    return contact, q.ravel()


def residual(contact, q):
    out = np.zeros_like(q)
    contact.set_state(q)
    contact.add_residual(out)
    return out


def tangent(contact, q):
    contact.set_state(q)
    return sp.csr_matrix((contact.tangent_values(), contact.tangent_pattern()), shape=(len(q),) * 2)


@pytest.mark.parametrize("friction", [0.0, 0.2])
@pytest.mark.parametrize("block", [3, 9], ids=["cables", "beams"])
@pytest.mark.parametrize("angle", [8, 40, 60, 90, 130])
def test_tangent_is_the_derivative_of_the_residual(angle, block, friction):
    contact, q = contact_at(angle, block, friction)
    arrays = contact.arrays()
    assert contact.results(q)["gap"].min() < -0.01
    assert (arrays["station"] == POINT).any() == (angle > 8)
    assert np.all(arrays["follows"] != 0)
    step = 1e-7 * np.random.default_rng(5).standard_normal(len(q))
    change = residual(contact, q + step) - residual(contact, q - step)
    error = change - 2 * tangent(contact, q) @ step
    assert np.linalg.norm(error) < 1e-5 * np.linalg.norm(change)


def test_fresh_contact_elements_leave_no_residual():
    """Followed sections are those that an update finds: the pairing of a rigid motion stays consistent."""
    contact, q = contact_at(60, 3)
    turn = Rotation.from_rotvec([0.5, -0.6, 0.7])
    moved = turn.apply(q.reshape(-1, 3)).ravel()
    expected = turn.apply(residual(contact, q).reshape(-1, 3)).ravel()
    followed = residual(contact, moved)
    contact.update(moved)
    fresh = residual(contact, moved)
    size = np.abs(expected).max()
    assert followed == pytest.approx(expected, abs=1e-6 * size)
    assert fresh == pytest.approx(expected, abs=1e-6 * size)


@pytest.mark.parametrize("block", [3, 9], ids=["cables", "beams"])
@pytest.mark.parametrize("angle", [8, 40, 60, 90, 130])
def test_new_contact_elements_change_forces_and_energy_continuously(angle, block):
    """Weights and stations are those of the last update: what a new pairing changes falls with the way slid since."""
    turn = np.radians(angle) / 2
    along = np.zeros((2, NODES, block))
    along[1, :, 1:3] = np.sin(turn), np.cos(turn)
    for way in (0.01, 0.1):
        contact, q = contact_at(angle, block)
        q = q + way * RADIUS * along.ravel()
        before = residual(contact, q), contact.energy(np.ones_like(q))
        contact.update(q)
        after = residual(contact, q), contact.energy(np.ones_like(q))
        # Measured: at most 1.2 of the way over the radius in forces, 1.5 in the energy, at 60 degrees.
        assert np.linalg.norm(after[0] - before[0]) < 1.5 * way * np.linalg.norm(before[0])
        assert abs(after[1] - before[1]) < 2.0 * way * before[1]


def test_a_step_ends_before_centre_lines_pass_through_each_other():
    contact, q = contact_at(60, 3)
    step = np.zeros((2, NODES, 3))
    step[1, :, 0] = -20.0 * RADIUS
    share = contact.max_step(q, step.ravel())
    apart = (q.reshape(2, NODES, 3)[1, NODES // 2] - q.reshape(2, NODES, 3)[0, NODES // 2])[0]
    assert 0.85 * apart < 20.0 * share < 1.05 * apart
    assert contact.max_step(q, -step.ravel()) == 1.0
