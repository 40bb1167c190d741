"""Slender bars of solids: deflection after Timoshenko, torsion after Saint-Venant, no locking."""

import numpy as np
import pytest
from example_solids import bar, displacements
from mpi4py import MPI

from braidx.bodies import SolidBody, YarnMaterial
from braidx.meshing import rectangle, round_section

LENGTH = 10.0
YARN = YarnMaterial(1000.0, 50.0, 20.0, 0.3, 0.3)
STEEL, RUBBER = (YarnMaterial.isotropic(100.0, poisson) for poisson in (0.3, 0.49))
SQUARE_TORSION = 0.1406  # J of a square over the fourth power of its side
KAPPA = 5.0 / 6.0  # shear area of a square over its area; 0.9 is a round section's


def compliances(section, material, law="transversely isotropic", num_elements=20):
    """Deflection under a unit force and twist under a unit moment at the end of a bar held at its start.

    The start is held along the bar, and across it only against rigid motion: sections contract freely.
    """
    body = SolidBody(MPI.COMM_SELF, bar(section, LENGTH, num_elements), material=material, law=law)
    first, *_, last = body.mesh.sweeps[0].layers
    xi, weights = section.points, section.weights() / section.weights().sum()
    level = np.flatnonzero(np.abs(xi[:, 1] - xi[0, 1]) < 1e-9)
    far = level[np.abs(xi[level, 0] - xi[0, 0]).argmax()]
    held = np.r_[3 * first + 2, 3 * first[0], 3 * first[0] + 1, 3 * first[far] + 1]
    turning = np.stack([-xi[:, 1], xi[:, 0]], axis=1) * weights[:, None]
    lever = np.sum(turning * np.stack([-xi[:, 1], xi[:, 0]], axis=1))
    results = []
    for pattern, measure in (
        (np.stack([weights, 0.0 * weights], axis=1),) * 2,
        (turning / lever,) * 2,
    ):
        loads = np.zeros((body.num_nodes, 3))
        loads[last, :2] = pattern
        u = displacements(body, loads, held)
        results.append(np.sum(measure * (u[last] - u[first])[:, :2]))
    return results


def timoshenko(section, material, kappa):
    area, inertia, _ = section.moments()
    bending = LENGTH**3 / (3.0 * material.axial_modulus * inertia)
    return bending + LENGTH / (kappa * material.axial_shear_modulus * area)


@pytest.mark.parametrize("material", [YARN, STEEL, RUBBER], ids=["yarn", "steel", "rubber"])
@pytest.mark.parametrize("count", [1, 2])
def test_square_bar_with_one_or_two_cells_over_it(count, material):
    section = rectangle(1.0, 1.0, (count, count))
    deflection, _ = compliances(section, material)
    assert deflection == pytest.approx(timoshenko(section, material, KAPPA), rel=0.03)


@pytest.mark.parametrize("material", [YARN, STEEL, RUBBER], ids=["yarn", "steel", "rubber"])
@pytest.mark.parametrize("template", ["o-grid", "wedge"])
def test_round_bar_of_twelve_seeds(template, material):
    section = round_section(0.5, 12, template=template)
    deflection, twist = compliances(section, material)
    polar = sum(section.moments()[1:])
    assert deflection == pytest.approx(timoshenko(section, material, 0.9), rel=0.035)
    assert twist == pytest.approx(LENGTH / (material.axial_shear_modulus * polar), rel=0.005)


def test_cells_that_are_long_do_not_lock():
    """Aspect ratio 10: five cells of 2 mm along a bar of 0.2 mm, whose deflection nodes see exactly but for
    what two-node beams lack."""
    section = rectangle(0.2, 0.2)
    deflection, _ = compliances(section, YARN, num_elements=5)
    exact = timoshenko(section, YARN, KAPPA)
    assert deflection == pytest.approx(exact * (1.0 - 0.25 / 5.0**2), rel=2e-3)


@pytest.mark.parametrize("law", ["Saint-Venant-Kirchhoff", "neo-Hooke"])
def test_laws_without_fibre_keep_the_volume_without_locking(law):
    section = rectangle(1.0, 1.0, (4, 4))
    deflection, twist = compliances(section, RUBBER, law)
    assert deflection == pytest.approx(timoshenko(section, RUBBER, KAPPA), rel=0.03)
    exact = LENGTH / (RUBBER.axial_shear_modulus * SQUARE_TORSION)
    assert twist == pytest.approx(exact, rel=0.06)  # its warping takes more cells


@pytest.mark.parametrize("material", [YARN, RUBBER], ids=["yarn", "rubber"])
def test_degree_2(material):
    section = round_section(0.5, 8, template="wedge", degree=2)
    deflection, twist = compliances(section, material, num_elements=6)
    polar = sum(section.moments()[1:])
    assert deflection == pytest.approx(timoshenko(section, material, 0.9), rel=0.01)
    assert twist == pytest.approx(LENGTH / (material.axial_shear_modulus * polar), rel=0.005)
