"""Centre lines for verification cases."""

import numpy as np

from braidx.geometry.curves import arc, helix, ring, straight


def length(nodes):
    return np.linalg.norm(np.diff(nodes, axis=0), axis=1).sum()


def test_straight():
    nodes = straight([0, 0, 1], [0, 4, 4], 11)
    assert nodes.shape == (11, 3)
    assert np.allclose(np.diff(nodes, axis=0), [0, 0.4, 0.3])


def test_arc_starts_along_x_and_turns_towards_y():
    nodes = arc(100.0, np.pi / 4, 2001)
    assert np.allclose(nodes[0], 0.0)
    assert np.allclose(nodes[-1], [100 * np.sin(np.pi / 4), 100 * (1 - np.cos(np.pi / 4)), 0])
    assert np.isclose(length(nodes), 100.0 * np.pi / 4)


def test_helix_is_right_handed_for_a_positive_pitch():
    nodes = helix(10.0, 25.0, 50.0, 4001)
    assert np.allclose(nodes[[0, -1]], [[10, 0, 0], [10, 0, 50]])
    assert np.isclose(length(nodes), 2 * np.hypot(20 * np.pi, 25.0), rtol=1e-5)
    assert nodes[1, 1] > 0 > helix(10.0, -25.0, 50.0, 4001)[1, 1]


def test_ring_closes():
    nodes = ring(3.0, 500)
    assert np.array_equal(nodes[0], nodes[-1])
    assert np.isclose(length(nodes), 6 * np.pi, rtol=1e-4)
