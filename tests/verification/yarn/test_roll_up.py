"""V1: an end moment 2 pi EI / L rolls a straight rod up to a closed circle (exact)."""

import numpy as np
import pytest
from slender import circle

from braidx.rods import Beam, BeamSection, Rods, YarnMaterial, straight

LENGTH, STIFFNESS = 1.0, 1.0
MOMENT = 2.0 * np.pi * STIFFNESS / LENGTH
RADIUS = STIFFNESS / MOMENT
MATERIAL = YarnMaterial(1.0, 1.0, 0.5)


def roll_up(num_elements, degree, stiff):
    """`stiff` is area over inertia: stretch and shear are about 40 over that."""
    section = BeamSection(stiff, 1.0, 1.0, 2.0, stiff)
    line = straight((0, 0, 0), (LENGTH, 0, 0), num_elements * degree)
    rods = Rods([Beam(line, 0.01, MATERIAL, section, degree=degree)])
    rods.clamp(0, 0)
    rods.couple(0, -1, (0.0, 0.0, MOMENT))
    rods.solve(increments=8)
    return rods


def l2_error(x, num_elements, degree):
    """L2 norm of the error of the interpolated axis, by five Gauss points per element."""
    points, weights = np.polynomial.legendre.leggauss(5)
    nodes = np.linspace(-1.0, 1.0, degree + 1)
    shape = np.linalg.inv(np.vander(nodes)).T @ np.vander(points, degree + 1).T
    element = LENGTH / num_elements
    total = 0.0
    for e in range(num_elements):
        axis = shape.T @ x[e * degree : (e + 1) * degree + 1, :2]
        s = element * (e + 0.5 + 0.5 * points)
        total += 0.5 * element * weights @ np.sum((axis - circle(s, RADIUS)) ** 2, axis=1)
    return np.sqrt(total)


@pytest.mark.parametrize("degree, meshes, stiff", [(1, (8, 16, 32), 1e6), (2, (4, 8, 16), 1e7)])
def test_order_of_convergence(record, degree, meshes, stiff):
    errors = [l2_error(roll_up(n, degree, stiff).positions(0), n, degree) for n in meshes]
    what = f"roll-up, axis in L2, degree {degree}"
    record.converges("V1", what, meshes, errors, degree + 0.8)


def test_circle_is_closed(record):
    rods = roll_up(16, 2, 1e8)
    x, unknowns = rods.positions(0), rods.q.size
    shortening = LENGTH - x[-1, 0]
    record.check("V1", "roll-up: tip shortening / L", shortening, LENGTH, 1e-4, unknowns=unknowns)
    assert x[-1, 1] == pytest.approx(0.0, abs=1e-6)
    directors = rods.directors(0)
    assert directors[-1] == pytest.approx(directors[0], abs=1e-3)
    exact = circle(np.linspace(0.0, LENGTH, len(x)), RADIUS)
    record.check("V1", "roll-up: nodes / L", x[:, :2], exact, 1e-4, scale=LENGTH, unknowns=unknowns)
