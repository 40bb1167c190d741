"""C6 and C7: parallel rods in line contact, whatever their meshes."""

import braidx_engine as engine
import numpy as np
import pytest
from mpi4py import MPI
from support import Rods, cables, straight

from braidx.bodies import BeamBody, BeamSection, YarnMaterial

RADIUS, LENGTH = 1.0, 20.0
PENALTY = 500.0  # N/mm per mm


def pressed(num_elements, shift, load, beams=True):
    """A rod pressed by a line load (N/mm) onto one that is held, its mesh and ends shifted along it."""
    start = -LENGTH / 2 + shift
    lines = [
        straight((0, 0, -LENGTH), (0, 0, LENGTH), 16),
        straight((2 * RADIUS, 0, start), (2 * RADIUS, 0, start + LENGTH), num_elements),
    ]
    if beams:
        section, material = BeamSection.round(RADIUS), YarnMaterial.isotropic(1e4, 0.0)
        body = BeamBody(MPI.COMM_SELF, lines, section=section, material=material)
    else:
        body = cables(lines, 1e4, 100.0)
    rods = Rods(body, RADIUS, penalty=PENALTY)
    lower, upper = rods.nodes(0), rods.nodes(1)
    share = np.full(num_elements + 1, LENGTH / num_elements)
    share[[0, -1]] /= 2
    rods.loads[upper, 0] = -load * share
    rods.hold(lower)
    rods.hold(upper, slice(1, 3))
    if beams:
        rods.hold(upper, slice(3, 9))
    rods.solve()
    return rods


MESHES = [(10, 0.0), (10, 0.37), (13, 0.0), (13, 1.1), (31, -0.83)]


@pytest.mark.parametrize("beams", [True, False], ids=["beams", "cables"])
@pytest.mark.parametrize("num_elements, shift", MESHES)
def test_patch(num_elements, shift, beams):
    """C6: forces sum to q L, penetration is q / k.

    A cable has no bending stiffness to level out the difference between a load on its straight
    elements and one on the smooth tube around them: it is judged three elements off its ends.
    """
    load = 2.5
    rods = pressed(num_elements, shift, load, beams)
    contacts = rods.contacts()
    assert contacts["normal_force"].sum() == pytest.approx(load * LENGTH, rel=1e-6)
    assert rods.reactions()[rods.nodes(0), 0].sum() == pytest.approx(load * LENGTH, rel=1e-6)
    penetration = -contacts["gap"] - rods.contact.laws.regularisation / 2
    if not beams:
        s = contacts["s"][:, 1]
        penetration = penetration[(s > 3) & (s < num_elements - 3)]
    assert penetration == pytest.approx(np.full(len(penetration), load / PENALTY), rel=0.01)


def test_seven_rods():
    """C7: six rods pressed onto a seventh by a bore: six equal forces on the core, six on the bore."""
    angle = np.pi / 3 * np.arange(6)
    places = [(0.0, 0.0), *zip(2 * RADIUS * np.cos(angle), 2 * RADIUS * np.sin(angle))]
    body = cables([straight((x, y, 0), (x, y, LENGTH), 12) for x, y in places], 1e4, 50.0)
    axis = np.array([0.0, 0.0, 1.0])
    bore = engine.make_cylinder(0 * axis, axis, 3 * RADIUS - 0.02, True, 0)
    rods = Rods(body, RADIUS, penalty=PENALTY, rigid=[bore])
    rods.viscosity[:] = 20.0  # all six may turn about the core
    rods.hold(slice(None), 2)
    for _ in range(4):
        rods.solve()
    contacts = rods.contacts()
    a, b = contacts["tubes"].T
    force = contacts["normal_force"]
    core = np.array([force[(a == 0) & (b == rod)].sum() for rod in range(1, 7)])
    wall = np.array([force[(a == rod) & (b < 0)].sum() for rod in range(1, 7)])
    beside = force[(a > 0) & (b > 0)].sum() / 6
    assert core == pytest.approx(np.full(6, core.mean()), rel=1e-6)
    assert wall == pytest.approx(np.full(6, core.mean() + beside), rel=1e-6)
    assert core.mean() > 1
