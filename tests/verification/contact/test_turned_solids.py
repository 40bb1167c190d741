"""V11: two blocks pressed and dragged turn with all that holds them: nothing happens to them (exact)."""

import numpy as np
from assembly import Assembly
from mpi4py import MPI
from scipy.spatial.transform import Rotation

from braidx.bodies import SolidBody, YarnMaterial
from braidx.meshing import rectangle, sweep
from braidx.rods import straight

LOWER, UPPER = 0, 1
HEIGHT = 1.0
CENTRE = np.array([3.0, -2.0, 1.0])
SOLVED = "equilibria are found to 1e-10 of the forces, which bounds how far a reaction comes back."


def block(low, high, counts):
    """Hexahedra between two corners."""
    low, size = np.array(low), np.array(high) - np.array(low)
    start = low + [0.0, size[1] / 2, size[2] / 2]
    line = straight(start, start + [size[0], 0.0, 0.0], counts[0])
    section = rectangle(size[1], size[2], counts[1:])
    mesh = sweep(line, section, np.broadcast_to(np.eye(3)[1:], (len(line), 2, 3)))
    return SolidBody(MPI.COMM_SELF, mesh, material=YarnMaterial.isotropic(1e3, 0.3))


def pressed():
    """A small block on a larger one, its top pressed down and dragged; friction holds some of it, and some slides."""
    bodies = [
        block((0, 0, -HEIGHT), (3, 2, 0), (3, 2, 1)),
        block((0.6, 0.4, 0), (2.4, 1.6, HEIGHT), (2, 2, 1)),
    ]
    scene = Assembly(
        bodies,
        {LOWER: "lateral", UPPER: "lateral"},
        penalty=1e4,
        length=HEIGHT,
        friction=0.3,
        tolerance=1e-10,
    )
    scene.contact.laws.reversible_slip = 0.005
    scene.hold(LOWER, np.flatnonzero(bodies[LOWER].rest[:, 2] < 1e-9 - HEIGHT))
    top = np.flatnonzero(bodies[UPPER].rest[:, 2] > HEIGHT - 1e-9)
    scene.hold(UPPER, top)
    for by in [(0.0, 0.0, -0.04), (0.015, 0.01, 0.0)]:
        scene.of(UPPER, scene.held)[top] += by
        scene.solve()
    return scene


def energy(scene):
    return sum(body.energy() for body in scene.bodies)


def test_turn(record):
    scene = pressed()
    slip = np.linalg.norm(scene.contact.elements.arrays()["slip"], axis=1)
    assert slip.max() > 0.004 and np.ptp(slip[slip > 0.0]) > 1e-4
    reaction, before = scene.reactions(), energy(scene)
    step = np.array([0.3, -0.5, np.sqrt(0.66)]) * 2.0 * np.pi / 12
    turn = Rotation.from_rotvec(step)

    def turned(values):
        return (CENTRE + turn.apply(values.reshape(-1, 3) - CENTRE)).ravel()

    work = 0.0
    for _ in range(12):
        scene.held[:] = turned(scene.held)
        work += scene.solve(turned(scene.q)).friction_work
    what = "solids, mu = 0.3, turned by 360 degrees: "
    options = {"unknowns": scene.q.size, "missed": SOLVED, "measured": 1e-9}
    size = np.linalg.norm(reaction)
    record.check(
        "V11", what + "reaction", scene.reactions(), reaction, 1e-12, scale=size, **options
    )
    record.check("V11", what + "energy", energy(scene), before, 1e-12, **options)
    record.check("V11", what + "friction work", work, 0.0, 1e-12, scale=before, **options)
