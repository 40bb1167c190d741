"""Shear of sections at the nodes: derivatives, rigid motions, what it sees and what it does not."""

import numpy as np
import pytest

from braidx.bodies.layout import CurveLayout
from braidx.bodies.tilt import SectionTilt

NODES = 7


def ring(bend=0.02):
    """Nodes on an arc of curvature `bend` (1/mm) with directors normal to it, shape (NODES, 9)."""
    angle = bend * np.arange(NODES)
    x = np.column_stack([np.sin(angle), 1.0 - np.cos(angle), 0.0 * angle]) / bend
    across = np.column_stack([-np.sin(angle), np.cos(angle), 0.0 * angle])
    return np.hstack([x, across, np.tile([0.0, 0.0, 1.0], (NODES, 1))])


def straight():
    return ring(1e-9)


def term(rest):
    return SectionTilt(
        CurveLayout.from_node_counts([NODES, NODES], 1), np.vstack([rest, rest]), 5.0
    )


def zigzag(size):
    """Sections tilted to and fro by `size` (rad)."""
    turned = straight()
    angle = size * (-1.0) ** np.arange(NODES)
    turned[:, 3:6] = np.column_stack([np.sin(angle), np.cos(angle), 0.0 * angle])
    return turned


@pytest.fixture
def shaken():
    tilt = term(ring())
    q = np.vstack([ring(0.05), ring(-0.03)]).ravel()
    return tilt, q + 0.1 * np.random.default_rng(0).standard_normal(len(q))


def differences(function, tilt, q, step=1e-6):
    columns = []
    for i in range(len(q)):
        values = []
        for sign in (1.0, -1.0):
            moved = q.copy()
            moved[i] += sign * step
            tilt.set_state(moved)
            values.append(function())
        columns.append((values[0] - values[1]) / (2.0 * step))
    tilt.set_state(q)
    return np.array(columns)


def residual(tilt, size):
    out = np.zeros(size)
    tilt.add_residual(out)
    return out


def test_residual_and_tangent_are_derivatives(shaken):
    tilt, q = shaken
    slopes = differences(tilt.energy, tilt, q)
    assert residual(tilt, len(q)) == pytest.approx(slopes, abs=1e-7)
    tangent = np.zeros((len(q), len(q)))
    np.add.at(tangent, tilt.tangent_pattern(), tilt.tangent_values())
    assert tangent == pytest.approx(differences(lambda: residual(tilt, len(q)), tilt, q), abs=1e-6)
    assert tangent == pytest.approx(tangent.T, abs=1e-12)


def test_rigid_rotations_cost_nothing(shaken):
    tilt, q = shaken
    tilt.set_state(q)
    before = tilt.energy()
    axis = np.array([[0.0, -0.3, 0.5], [0.3, 0.0, -0.8], [-0.5, 0.8, 0.0]])
    turn = np.linalg.qr(np.eye(3) + axis)[0]
    tilt.set_state((q.reshape(-1, 3) @ turn).ravel())
    assert tilt.energy() == pytest.approx(before, rel=1e-12)


def test_even_bending_costs_nothing_and_zigzag_what_shear_of_all_sections_would():
    tilt = term(straight())
    tilt.set_state(np.vstack([ring(0.05), ring(0.05)]).ravel())
    assert tilt.energy() == pytest.approx(0.0, abs=1e-12)
    tilt.set_state(np.vstack([zigzag(0.01), straight()]).ravel())
    inner = NODES - 2  # elements are 1 mm long
    assert tilt.energy() == pytest.approx(0.5 * 5.0 * np.sin(0.01) ** 2 * inner, rel=1e-6)
