"""A yarn as beam or cable that lies on a block of hexahedra: line load, penetration, friction when it slides or rolls.

All places are away from rows of nodes: in the dent of a soft block, whose bottom is such a row, the nearest places of
the axis lie on either side of it.
"""

import numpy as np
import pytest
from assembly import Assembly
from mpi4py import MPI
from support import cables

from braidx.bodies import BeamBody, BeamSection, SolidBody, YarnMaterial
from braidx.meshing import rectangle, sweep
from braidx.rods import straight

LENGTH, RADIUS = 6.0, 1.0
WIDTH, HEIGHT = 5.0, 2.0
LOAD, PENALTY, FRICTION = 5.0, 500.0, 0.2  # N/mm, N/mm per mm
SOFT, HARD = 200.0, 2e4  # MPa
CURVE, BLOCK = 0, 1


def tube(model, num_elements):
    """Along x, lying on z = 0, a little too deep; directors along y and z."""
    line = straight((0, 0, RADIUS - 0.02), (LENGTH, 0, RADIUS - 0.02), num_elements)
    if model == "cable":
        return cables([line], 1e4, 100.0)
    return BeamBody(
        MPI.COMM_SELF,
        [line],
        section=BeamSection.round(RADIUS),
        material=YarnMaterial.isotropic(1e4, 0.0),
        directors=[np.broadcast_to(np.eye(3)[1:], (num_elements + 1, 2, 3))],
    )


def lying(model, num_elements, counts, degree=1, *, modulus=SOFT, beyond=0.0, friction=0.0):
    """The tube under its load, free along z only, on the block, which is held below and may not get longer.

    Args:
        counts: Hexahedra along x, y and z.
        modulus: Of the block, MPa.
        beyond: Length of the block past either end of the tube, mm.
    """
    along, *across = counts
    line = straight((-beyond, 0, -HEIGHT / 2), (LENGTH + beyond, 0, -HEIGHT / 2), degree * along)
    section = rectangle(WIDTH, HEIGHT, tuple(across), degree)
    mesh = sweep(line, section, np.broadcast_to(np.eye(3)[1:], (len(line), 2, 3)))
    block = SolidBody(MPI.COMM_SELF, mesh, material=YarnMaterial.isotropic(modulus, 0.3))
    scene = Assembly(
        [tube(model, num_elements), block],
        {BLOCK: "lateral"},
        tube_radius=RADIUS,
        penalty=PENALTY,
        length=RADIUS,
        spacing=0.5 * LENGTH / num_elements,
        friction=friction,
    )
    nodes = np.arange(num_elements + 1)
    share = np.full(num_elements + 1, LENGTH / num_elements)
    share[[0, -1]] /= 2
    scene.of(CURVE, scene.loads)[:, 2] = -LOAD * share
    scene.hold(CURVE, nodes, [0, 1])
    if model == "beam":
        scene.hold(CURVE, nodes, slice(3, 9))
    scene.hold(BLOCK, np.arange(block.num_nodes), [0])
    scene.hold(BLOCK, np.flatnonzero(block.rest[:, 2] < 1e-9 - HEIGHT))
    scene.solve()
    return scene


MESHES = [(6, (6, 5, 2), 1), (8, (5, 5, 2), 1), (7, (3, 3, 1), 2)]


@pytest.mark.parametrize("model", ["beam", "cable"])
@pytest.mark.parametrize("num_elements, counts, degree", MESHES)
def test_pressed(record, num_elements, counts, degree, model):
    """Forces sum to q L on both sides. Penetration is q / k: on average to round-off, everywhere within 1.7 % under
    a beam, whose stations and nodes do not match those of the block; a cable is judged two elements off its ends.
    """
    scene = lying(model, num_elements, counts, degree)
    contacts = scene.contacts()
    force = LOAD * LENGTH
    what, size = f"patch of a {model} on hexahedra: ", scene.q.size
    normal = contacts["normal_force"].sum()
    record.check("C6", what + "sum q L", normal, force, 1e-5, unknowns=size)
    below = scene.of(BLOCK, scene.reactions()).sum(axis=0)
    assert below == pytest.approx([0.0, 0.0, force], abs=1e-5 * force)
    penetration = -contacts["gap"] - scene.contact.laws.regularisation / 2
    mean = np.average(penetration, weights=contacts["weight"])
    record.check("C6", what + "mean penetration q / k", mean, LOAD / PENALTY, 1e-5, unknowns=size)
    s = contacts["s"][:, 0]
    inside = (s > 2) & (s < num_elements - 2) if model == "cable" else s > 0
    assert penetration[inside] == pytest.approx(LOAD / PENALTY, rel=0.02)


def sliding(model, modulus):
    return lying(model, 6, (9, 5, 2), modulus=modulus, beyond=2.0, friction=FRICTION)


def pulled(scene, axis):
    """Force on the tube along an axis over mu N."""
    force = scene.of(CURVE, scene.reactions())[:, axis].sum()
    return force / (FRICTION * LOAD * LENGTH)


@pytest.mark.parametrize("model", ["beam", "cable"])
@pytest.mark.parametrize("axis", [0, 1], ids=["along", "across"])
def test_sliding(record, axis, model):
    """Over one and a half facets of a hard block: mu N, wherever nodes are."""
    scene = sliding(model, HARD)
    for _ in range(8):
        scene.of(CURVE, scene.held)[:, axis] += 0.2
        scene.solve()
        what, got = f"{model} that slides over hexahedra: friction over mu N", pulled(scene, axis)
        record.check("C8", what, got, 1.0, 5e-3, unknowns=scene.q.size)


def test_sliding_over_a_soft_block():
    """Friction is mu N; the slope of the dent, which facets make uneven (up to 17 % of mu N), comes to nothing over one
    of them, 1 mm wide."""
    scene, forces = sliding("beam", SOFT), []
    for _ in range(5):
        scene.of(CURVE, scene.held)[:, 1] += 0.2
        scene.solve()
        contacts = scene.contacts()
        friction = np.linalg.norm(contacts["friction_force"], axis=1)
        assert friction == pytest.approx(FRICTION * contacts["normal_force"], rel=1e-9)
        forces.append(pulled(scene, 1))
    assert np.mean(forces) == pytest.approx(1.0, rel=0.02)


@pytest.mark.parametrize("turn, expected", [(-1.0, 0.0), (1.0, 1.0)], ids=["rolling", "spinning"])
def test_turning(turn, expected):
    """A beam that turns as it moves across rolls without friction, or has all of it the other way round.

    It rolls on the distance of its axis from the block. Of each step t of rolling t - sin t is slip.
    """
    scene = sliding("beam", HARD)
    distance = RADIUS + np.mean(scene.contacts()["gap"])
    curve, start = scene.of(CURVE, scene.held), scene.of(CURVE).copy()
    for angle in 0.02 * np.arange(1, 9):
        curve[:, 1] = start[:, 1] + distance * angle
        c, s = np.cos(turn * angle), np.sin(turn * angle)
        curve[:, 3:] = [0.0, c, s, 0.0, -s, c]
        scene.solve()
        assert pulled(scene, 1) == pytest.approx(expected, abs=0.02)
