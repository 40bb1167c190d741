"""V11: two rods pressed together turn once round with all their supports: nothing happens to them (exact)."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, Rods, YarnMaterial, straight

RADIUS, LENGTH = 1.0, 20.0
ENDS = [0, -1]
CENTRE = np.array([3.0, -2.0, 1.0])


FRICTION = (
    "reactions and energy drift by some per cent in a full turn, about as much in small steps as in large ones. The "
    "slip of an increment is the difference of two distances of particles that are a penetration apart, so that a turn "
    "of the normal looks like slip; and what is remembered of it turns with the normal, not about it."
)


SOLVED = "equilibria are found to 1e-10 of the forces, which bounds how far a reaction comes back."


def pressed(friction):
    """Crossing rods, pushed into each other and one along the other."""
    lines = [
        straight((0, 0, -LENGTH / 2), (0, 0, LENGTH / 2), 24),
        straight((2.0 * RADIUS, -LENGTH / 2, 0), (2.0 * RADIUS, LENGTH / 2, 0), 24),
    ]
    material = YarnMaterial.isotropic(1e3, 0.3)
    rods = Rods(
        [Beam(line, RADIUS, material) for line in lines], friction=friction, tolerance=1e-10
    )
    for rod in (0, 1):
        rods.clamp(rod, ENDS)
    rods.move(1, ENDS, by=(-0.5, 0.0, 0.2))
    rods.solve(increments=4)
    return rods


def spin(rods, steps):
    """Turns all supports once about an axis that is none of the rods'; sought near the turned state."""
    step = np.array([0.3, -0.5, np.sqrt(0.66)]) * 2.0 * np.pi / steps
    turn = Rotation.from_rotvec(step)
    for _ in range(steps):
        for rod in (0, 1):
            rods.move(rod, ENDS, turn=step, about=CENTRE)
        nodes = rods.q.reshape(-1, 3, 3)
        guess = np.stack([turn.apply(nodes[:, i]) for i in range(3)], axis=1)
        guess[:, 0] += CENTRE - turn.apply(CENTRE)
        rods.solve(guess=guess.ravel())


@pytest.mark.parametrize(
    "friction, missed, measured",
    [(0.0, SOLVED, 1e-10), (0.3, FRICTION, 0.1)],
    ids=["frictionless", "friction"],
)
def test_turn(record, friction, missed, measured):
    rods = pressed(friction)
    reaction, energy, work = rods.reaction(0, 0)[0], rods.elastic_energy(), rods.friction_work
    spin(rods, 12)
    options = {"unknowns": rods.q.size, "missed": missed, "measured": measured}
    what = f"turn of 360 degrees, mu = {friction:g}: "
    back, scale = rods.reaction(0, 0)[0], np.linalg.norm(reaction)
    record.check("V11", what + "reaction", back, reaction, 1e-12, scale=scale, **options)
    record.check("V11", what + "energy", rods.elastic_energy(), energy, 1e-12, **options)
    lost = rods.friction_work - work
    record.check("V11", what + "friction work", lost, 0.0, 1e-12, scale=energy, **options)
