"""V4 and V5: arc of 45 degrees under a dead load out of its plane."""

import numpy as np
import pytest
from mpi4py import MPI
from single_rod import dead_force, equilibrium

from braidx.bodies import BeamBody, BeamSection, YarnMaterial

RADIUS = 100.0
EXACT = np.array([-23.56024, -13.60452, 53.47486])  # shear-deformable, square section of side 1
KIRCHHOFF = np.array([-23.55938, -13.60424, 53.46860])


def tip_displacement(side, load, num_elements, degree, transverse_modulus=1e7):
    """Displacement of the tip, shape (3,); square section, the arc starts along x, towards y."""
    angle = np.linspace(0.0, np.pi / 4.0, num_elements * degree + 1)
    cos, sin, zero = np.cos(angle), np.sin(angle), 0.0 * angle
    line = RADIUS * np.stack([sin, 1.0 - cos, zero], axis=1)
    inward = np.stack([-sin, cos, zero], axis=1)
    upward = np.tile([0.0, 0.0, 1.0], (len(angle), 1))
    inertia = side**4 / 12.0
    body = BeamBody(
        MPI.COMM_SELF,
        [line],
        section=BeamSection(side**2, inertia, inertia, 2.0 * inertia, side**2),
        material=YarnMaterial(1e7, transverse_modulus, 0.5e7),
        directors=[np.stack([inward, upward], axis=1)],
        degree=degree,
    )
    q = equilibrium(body, dead_force([0.0, 0.0, load]), steps=6)
    return q[-1, :3] - line[-1]


def test_displacement():
    """Sections that hardly deform, as the exact value assumes."""
    displacement = tip_displacement(1.0, 600.0, 16, 2, transverse_modulus=1e9)
    assert np.abs(displacement - EXACT).max() < 1e-4 * np.linalg.norm(EXACT)


def test_order_of_degree_1():
    fine = tip_displacement(1.0, 600.0, 16, 2)
    errors = [np.linalg.norm(tip_displacement(1.0, 600.0, n, 1) - fine) for n in (4, 8, 16)]
    assert np.all(np.divide(errors[:-1], errors[1:]) > 3.5), errors


@pytest.mark.parametrize("slenderness, tolerance", [(1e2, 2e-4), (1e3, 1e-5), (1e4, 1e-5)])
def test_no_membrane_locking(slenderness, tolerance):
    side = RADIUS / slenderness
    displacement = tip_displacement(side, 600.0 * side**4, 16, 2)
    assert np.abs(displacement - KIRCHHOFF).max() < tolerance * np.linalg.norm(KIRCHHOFF)
