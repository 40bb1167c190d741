"""Finite rotations of sections: best fit, tilts and turn, against SciPy and finite differences."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.geometry import angles_of, best_fit, rates_of, rotation_of

ANGLES = [(0.0, 0.0, 0.0), (0.3, -0.2, 2.9), (1e-7, 2e-7, -1.0), (-1.0, 0.7, 0.1)]


@pytest.mark.parametrize("angles", ANGLES)
def test_angles_come_back(angles):
    assert angles_of(rotation_of(np.array(angles))) == pytest.approx(angles, abs=1e-12)


def test_several_turns_are_one_rotation():
    turned = rotation_of(np.array([0.0, 0.0, 6.0 * np.pi + 0.4]))
    assert angles_of(turned) == pytest.approx([0.0, 0.0, 0.4], abs=1e-12)


@pytest.mark.parametrize("angles", ANGLES)
def test_rates_are_derivatives_of_the_rotation(angles):
    at, rates, step = np.array(angles), rates_of(np.array(angles)), 1e-6
    for k in range(3):
        change = step * np.eye(3)[k]
        relative = rotation_of(at + change) @ rotation_of(at - change).T
        assert Rotation.from_matrix(relative).as_rotvec() / (2 * step) == pytest.approx(
            rates[:, k], abs=1e-8
        )


@pytest.mark.parametrize("flat", [False, True])
def test_best_fit_is_that_of_scipy(flat):
    rng = np.random.default_rng(1)
    arms = rng.standard_normal((6, 3)) * [1.0, 1.0, 0.0 if flat else 1.0]
    vectors = arms @ rotation_of(np.array([0.2, 0.1, 2.0])).T + 0.05 * rng.standard_normal((6, 3))
    exact = Rotation.align_vectors(vectors, arms)[0].as_matrix()
    np.testing.assert_allclose(best_fit(arms, vectors), exact, atol=1e-7)


def test_two_ends_turn_about_the_axis_and_do_not_spin_about_their_line():
    arms = np.array([[2.0, 0.0, 0.0], [-2.0, 0.0, 0.0]])
    for angle in (0.5, 3.0, -3.0):
        vectors = arms @ rotation_of(np.array([0.0, 0.0, angle])).T
        assert angles_of(best_fit(arms, vectors)) == pytest.approx([0.0, 0.0, angle], abs=1e-9)
