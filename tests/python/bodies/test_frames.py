"""Directors made from centre lines."""

import numpy as np
import pytest
from example_bodies import helix

from braidx.geometry.frames import nodal_tangents, rotation_minimising_frames


def test_frames_are_orthonormal_and_right_handed():
    lines = [helix(9, 0.0), helix(30, 1.0), np.linspace([0, 0, 0], [0, 0, 5.0], 4)]
    for line, frame in zip(lines, rotation_minimising_frames(lines)):
        g1, g2, t = frame[:, 0], frame[:, 1], nodal_tangents(line)
        assert np.abs(np.linalg.det(np.stack([g1, g2, t], axis=1)) - 1.0).max() < 1e-12
        for a, b, dot in ((g1, g1, 1), (g2, g2, 1), (g1, g2, 0), (g1, t, 0), (g2, t, 0)):
            assert np.abs(np.sum(a * b, axis=1) - dot).max() < 1e-12


def test_frames_do_not_spin():
    """Director 1 turns about the tangent by less than 1e-3 of the helix' geometric torsion."""
    line = helix(200, 0.0)
    (frame,) = rotation_minimising_frames([line])
    spin = np.sum(np.diff(frame[:, 0], axis=0) * (frame[1:, 1] + frame[:-1, 1]) / 2.0, axis=1)
    pitch, radius = 12.0 / (2.0 * np.pi), 3.0
    torsion = pitch / (radius**2 + pitch**2)
    length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    assert abs(spin.sum()) < 1e-3 * torsion * length


def test_first_direction_is_kept():
    line = np.linspace([0, 0, 0], [0, 0, 5.0], 4)
    (frame,) = rotation_minimising_frames([line], first=np.array([[0.0, 2.0, 1.0]]))
    assert frame[:, 0] == pytest.approx(np.tile([0.0, 1.0, 0.0], (4, 1)))


def test_tangents_are_exact_for_a_parabola_on_uneven_nodes_in_the_limit():
    errors = []
    for n in (40, 80):
        x = np.linspace(0.0, 1.0, n) ** 1.3
        tangents = nodal_tangents(np.stack([x, x**2, 0 * x], axis=1))
        exact = np.stack([np.ones(n), 2.0 * x, 0 * x], axis=1)
        exact /= np.linalg.norm(exact, axis=1, keepdims=True)
        errors.append(np.abs(tangents - exact).max())
    assert errors[1] < 0.35 * errors[0]
