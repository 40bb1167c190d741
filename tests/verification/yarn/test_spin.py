"""V11: two rods pressed together turn once round with all their supports: nothing happens to them (exact)."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from braidx.rods import Beam, Cable, Rods, YarnMaterial, straight

RADIUS, LENGTH = 1.0, 20.0
ENDS = [0, -1]
CENTRE = np.array([3.0, -2.0, 1.0])


SOLVED = (
    "round-off of positions, 4e-15 mm, over the length of a span and times EA is 1e-11 N in every element; reactions "
    "are a few newtons."
)


def rod(model, line):
    if model == "cables":
        return Cable(line, RADIUS, 1e3, tension=200.0)
    return Beam(line, RADIUS, YarnMaterial.isotropic(1e3, 0.3))


def pressed(model, friction, angle):
    """Rods that cross, pushed into each other and one along the other."""
    s, c = 0.5 * LENGTH * np.sin(angle), 0.5 * LENGTH * np.cos(angle)
    lines = [
        straight((0, 0, -LENGTH / 2), (0, 0, LENGTH / 2), 24),
        straight((2.0 * RADIUS, -s, -c), (2.0 * RADIUS, s, c), 24),
    ]
    rods = Rods([rod(model, line) for line in lines], friction=friction, tolerance=1e-12)
    for number in (0, 1):
        rods.clamp(number, ENDS)
    rods.move(1, ENDS, by=(-0.5, 0.0, 0.2))
    rods.solve(increments=4)
    for _ in range(2):  # contact elements, found within a tolerance, come to rest
        rods.solve()
    return rods


def spin(rods, steps):
    """Turns all supports once about an axis that is none of the rods'; sought near the turned state."""
    step = np.array([0.3, -0.5, np.sqrt(0.66)]) * 2.0 * np.pi / steps
    turn = Rotation.from_rotvec(step)
    for _ in range(steps):
        for number in (0, 1):
            rods.move(number, ENDS, turn=step, about=CENTRE)
        nodes = rods.q.reshape(-1, rods.layout.bodies[0].block // 3, 3)
        guess = np.stack([turn.apply(nodes[:, i]) for i in range(nodes.shape[1])], axis=1)
        guess[:, 0] += CENTRE - turn.apply(CENTRE)
        rods.solve(guess=guess.ravel())


@pytest.mark.parametrize(
    "model, friction, angle",
    [("beams", 0.0, 90), ("beams", 0.3, 80), ("cables", 0.3, 80), ("cables", 0.3, 10)],
)
def test_turn(record, model, friction, angle):
    rods = pressed(model, friction, np.radians(angle))
    reaction, energy, work = rods.reaction(0, 0)[0], rods.elastic_energy(), rods.friction_work
    assert (work > 0.0) == (friction > 0.0)
    spin(rods, 12)
    options = {"unknowns": rods.q.size, "missed": SOLVED, "measured": 1e-11}
    what = f"{model} at {angle} degrees, mu = {friction:g}, turned by 360 degrees: "
    back, scale = rods.reaction(0, 0)[0], np.linalg.norm(reaction)
    record.check("V11", what + "reaction", back, reaction, 1e-12, scale=scale, **options)
    record.check("V11", what + "energy", rods.elastic_energy(), energy, 1e-12, **options)
    lost = rods.friction_work - work
    record.check("V11", what + "friction work", lost, 0.0, 1e-12, scale=energy, **options)
