"""(j) A pulled rod is turned at one end until it forms a loop, a hockle, and may touch itself."""

from __future__ import annotations

import numpy as np

from braidx.rods import Beam, Rods, Scheme, YarnMaterial, curve
from family import Family
from judge import Outcome, Watch

LENGTH, RADIUS, MODULUS, TENSION = 100.0, 0.5, 1000.0, 0.2  # mm, MPa, N
BEND = 0.1  # mm: a straight rod would stay straight
SOLVED, MOVING = 0.0, 1.0
DENSITY, STEP = 1e-9, 0.01  # t/mm^3, s


def rod(viscosity: float = 0.0) -> Rods:
    """A nearly straight rod along x; its far end is held but for the pull along x."""

    def point(x: np.ndarray) -> np.ndarray:
        return np.stack([x, BEND * np.sin(np.pi * x / LENGTH), 0.0 * x], axis=1)

    beam = Beam(
        curve(point, 0.0, LENGTH, 100),
        RADIUS,
        YarnMaterial.isotropic(MODULUS, 0.3),
        density=DENSITY,
    )
    rods = Rods([beam], self_contact=5.0, viscosity=viscosity)
    rods.clamp(0, [0, -1])
    rods.release(0, -1, 0)
    return rods


def outcome(turns: float, way: float) -> Outcome:
    """Pulled, then turned at its near end in steps of a tenth of a turn."""
    rods = rod()
    watch = Watch(rods, conserves=False)
    rods.force(0, -1, (TENSION, 0.0, 0.0))
    done, number = watch.solve(2), max(1, round(turns / 0.1))
    for _ in range(number if done else 0):
        rods.move(0, 0, turn=(2.0 * np.pi * turns / number, 0.0, 0.0))
        done = (
            watch.solve(1)
            if way == SOLVED
            else watch.run(4 * STEP, STEP, scheme=Scheme.backward_euler())
        )
        if not done:
            break
    return watch.outcome(turns, way, shortening=1.0 - float(rods.positions(0)[-1, 0]) / LENGTH)


FAMILY = Family(
    "hockling",
    "A rod that is turned until it hockles",
    ("turns", "how"),
    ((1.0, 2.0, 3.0, 4.0), (SOLVED, MOVING)),
    outcome,
    "A rod of 200 radii under tension is turned at one end by tenths of a turn; from a torque of 2 √(EI T) on it "
    "leaves its line and forms a loop that touches itself.",
    logarithmic=(False, False),
    labels=("solve", "run"),
    means=(
        "Both go on through the snap, and wind the loop up; at four turns `run` stops with a message, where an "
        "element would be turned inside out. Before, it was "
        "wrong twice. The loop crosses itself at a place that moves by more than the distance of stations from one "
        "contact update to the next, was lost, and the rod overlapped itself by 10 % of a diameter unseen: such places "
        "are followed now, and contact that misses an overlap is looked for again. And an element that was turned "
        "inside out was a hinge through which the rod lost all its turns."
    ),
)
