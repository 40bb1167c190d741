"""V1: an end moment 2 pi EI / L rolls a straight rod up to a closed circle."""

import numpy as np
import pytest
from single_rod import couple_about_z, equilibrium, straight_rod

from braidx.bodies import BeamSection, YarnMaterial

LENGTH, STIFFNESS = 1.0, 1.0
MOMENT = 2.0 * np.pi * STIFFNESS / LENGTH
STIFF = 1e8  # area over inertia: stretch and shear of the order of 1e-7
SECTION = BeamSection(STIFF, 1.0, 1.0, 2.0, STIFF)
MATERIAL = YarnMaterial(1.0, 1.0, 0.5)


def circle(s):
    """Position at arc length s, shape (len(s), 2)."""
    radius = STIFFNESS / MOMENT
    return radius * np.stack([np.sin(s / radius), 1.0 - np.cos(s / radius)], axis=1)


def roll_up(num_elements, degree):
    body = straight_rod(LENGTH, num_elements, degree, SECTION, MATERIAL)
    return equilibrium(body, couple_about_z(MOMENT), steps=8)


def l2_error(q, num_elements, degree):
    """L2 norm of the error of the interpolated axis, by five Gauss points per element."""
    points, weights = np.polynomial.legendre.leggauss(5)
    nodes = np.linspace(-1.0, 1.0, degree + 1)
    shape = np.linalg.inv(np.vander(nodes)).T @ np.vander(points, degree + 1).T
    element = LENGTH / num_elements
    total = 0.0
    for e in range(num_elements):
        axis = shape.T @ q[e * degree : (e + 1) * degree + 1, :2]
        s = element * (e + 0.5 + 0.5 * points)
        total += 0.5 * element * weights @ np.sum((axis - circle(s)) ** 2, axis=1)
    return np.sqrt(total)


@pytest.mark.parametrize("degree, meshes", [(1, (8, 16, 32)), (2, (4, 8, 16))])
def test_order_of_convergence(degree, meshes):
    errors = [l2_error(roll_up(n, degree), n, degree) for n in meshes]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert np.all(orders > degree + 0.8), (errors, orders)


def test_circle_is_closed():
    q = roll_up(16, 2)
    shortening = LENGTH - q[-1, 0]
    assert shortening == pytest.approx(LENGTH, abs=1e-4)
    assert q[-1, 1] == pytest.approx(0.0, abs=1e-6)
    assert q[-1, 3:] == pytest.approx(q[0, 3:], abs=1e-3)
    assert np.abs(q[:, :2] - circle(np.linspace(0.0, LENGTH, len(q)))).max() < 1e-4
