"""The energy of frames: none in rigid motions, its gradient the residual, whose derivative the tangent."""

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.spatial.transform import Rotation

from braidx.rods.frames import Frame, RigidTerm, carried

SIZE = 30
FIRST = (6, 18)


@pytest.fixture
def term():
    rng = np.random.default_rng(5)
    axes = np.eye(3) + 0.2 * rng.standard_normal((3, 3))
    rests = np.append([1, 2, 3], axes), np.append([0, 0, 0], np.eye(3))
    frames = [Frame(f, k, rest) for f, k, rest in zip(FIRST, (40.0, 7.0), rests, strict=True)]
    return frames, RigidTerm(frames)


def residual(term, q):
    out = np.zeros(SIZE)
    term.set_state(q)
    term.add_residual(out)
    return out


def test_rigid_motions_cost_nothing(term):
    frames, term = term
    q = np.zeros(SIZE)
    for frame in frames:
        x = Rotation.from_rotvec([0.7, -2.0, 1.0]).apply(frame.rest.reshape(4, 3))
        x[0] += 4.0
        q[frame.unknowns[0]] = x.ravel()
    assert residual(term, q) == pytest.approx(np.zeros(SIZE), abs=1e-12)
    assert term.energy(np.ones(SIZE)) == pytest.approx(0.0, abs=1e-24)


def test_residual_and_tangent_are_derivatives(term):
    _, term = term
    rng = np.random.default_rng(6)
    q, way, h = rng.standard_normal(SIZE), rng.standard_normal(SIZE), 1e-6

    def energy(q):
        term.set_state(q)
        return term.energy(np.ones(SIZE))

    slope = (energy(q + h * way) - energy(q - h * way)) / (2 * h)
    assert residual(term, q) @ way == pytest.approx(slope, rel=1e-7)
    change = (residual(term, q + h * way) - residual(term, q - h * way)) / (2 * h)
    term.set_state(q)
    tangent = coo_matrix((term.tangent_values(), term.tangent_pattern()), shape=(SIZE, SIZE))
    assert tangent @ way == pytest.approx(change, rel=1e-7, abs=1e-6)


def test_other_processes_give_nothing(term):
    silent = RigidTerm(term[0], rank=1)
    assert not residual(silent, np.ones(SIZE)).any() and silent.tangent_values().size == 0


def test_nodes_are_where_the_frame_takes_them():
    """A node with two directors and one without, about axes that are not at right angles."""
    rng = np.random.default_rng(7)
    q, rest = rng.standard_normal(SIZE), rng.standard_normal(12)
    link = carried(18, rest, [np.arange(9), np.arange(9, 12)], q)
    q[18:] = rest
    turn, by = Rotation.from_rotvec([0.3, 1.0, -0.4]), np.array([0.0, 5.0, 1.0])
    moved = q.copy()
    moved[18:] = turn.apply(rest.reshape(4, 3)).ravel()
    moved[18:21] += by
    found = (link.factors * moved[link.leaders]).sum(axis=1).reshape(4, 3)
    want = turn.apply(q[:12].reshape(4, 3)) + np.array([[1], [0], [0], [1]]) * by
    assert found == pytest.approx(want, abs=1e-12)
