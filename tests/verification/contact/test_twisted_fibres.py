"""C4: two straight fibres, stretched and turned round each other, become a double helix."""

import numpy as np
import pytest
from mpi4py import MPI
from support import Rods, straight

from braidx.bodies import BeamBody, BeamSection, YarnMaterial

LENGTH, RADIUS, OFFSET = 5.0, 0.01, 0.0095
AREA, INERTIA, MODULUS = np.pi * 1e-4, 7.8539816e-9, 1e9
STRETCH, PENALTY = 0.04964722261, 4.6845279809533553e4
ELEMENTS = 80
MIDDLE, LOAD, END_FORCE = -0.019, 46.8452798, 3141.3715  # displacement, per rest length, per fibre

# The reference is linear in the stretch of the axis, T = E A (lambda - 1); the beam's law is
# T = E A lambda (lambda^2 - 1) / 2. Fibres are stretched by one per cent: equal there.
LAMBDA = 1.01
AXIAL = 2.0 / (LAMBDA * (LAMBDA + 1.0))


def fibres():
    """Shear hardly deforms the fibres, nor does transverse load; torsion costs next to nothing."""
    lines = [straight((x, 0, 0), (x, 0, LENGTH), ELEMENTS) for x in (-OFFSET, OFFSET)]
    frame = np.array([[1.0, 0, 0], [0, 1, 0]])
    inertia = INERTIA / AXIAL
    return BeamBody(
        MPI.COMM_SELF,
        lines,
        section=BeamSection(AREA, inertia, inertia, 2 * inertia, AREA),
        material=YarnMaterial(AXIAL * MODULUS, MODULUS, MODULUS),
        directors=[np.tile(frame, (ELEMENTS + 1, 1, 1))] * 2,
        torsion_factor=1e-2,
    )


def double_helix(rest):
    """First guess: sections turned with the ends and square to the helix, shape as `rest`."""
    x, z = rest[:, 0], rest[:, 2]
    angle, height = 2 * np.pi * z / LENGTH, (1 + STRETCH / LENGTH) * z
    cos, sin = np.cos(angle), np.sin(angle)
    radial = np.stack([cos, sin, 0 * z], axis=1)
    across = np.stack([-sin, cos, 0 * z], axis=1)
    climb = (LENGTH + STRETCH) / (2 * np.pi * x[:, None])  # of the helix, over its circumference
    binormal = (climb * across - [0, 0, 1]) / np.hypot(climb, 1) * np.sign(climb)
    return np.hstack([x[:, None] * radial + height[:, None] * [0, 0, 1], radial, binormal])


def twisted():
    """Fibres after one turn of their far end: numbers carry over, so the path there is the shortest."""
    rods = Rods(fibres(), RADIUS, penalty=PENALTY, tolerance=1e-8)
    rods.contact.laws.regularisation = 1e-9
    ends = [node for rod in (0, 1) for node in (rods.nodes(rod).start, rods.nodes(rod).stop - 1)]
    rods.hold(ends, slice(0, 6))  # g1 stays radial, so that the tangent has no radial component
    rods.held[:] = double_helix(rods.body.rest)
    rods.solve(rods.held)
    return rods, ends


def test_double_helix():
    rods, ends = twisted()
    middle = rods.nodes(1).start + ELEMENTS // 2
    moved = rods.q[middle, 0] - rods.body.rest[middle, 0]
    contacts = rods.contacts()
    load = contacts["normal_force"] / contacts["weight"]
    force = rods.reactions()[ends, 2]
    assert moved == pytest.approx(MIDDLE, rel=1e-3)
    assert -contacts["gap"] == pytest.approx(np.full(len(load), 1e-3), rel=1.5e-2)
    assert load == pytest.approx(np.full(len(load), LOAD), rel=1.5e-2)
    assert np.median(load) == pytest.approx(LOAD, rel=1e-3)
    assert np.abs(force) == pytest.approx(np.full(4, END_FORCE), rel=2e-5)
