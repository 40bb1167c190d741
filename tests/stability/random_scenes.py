"""(k) Random small scenes: two to five rods, random crossings and friction, pressed and slid."""

from __future__ import annotations

import numpy as np

from braidx.rods import Beam, Rods, YarnMaterial, straight
from family import Family
from judge import Outcome, Watch

COARSE, FINE = 0.0, 1.0


def scene(seed: int) -> tuple[Rods, np.random.Generator]:
    """Rods in layers above each other, turned so that no held ends are above each other, clamped."""
    random = np.random.default_rng(seed)
    beams, height, below = [], 0.0, 0.0
    for layer in range(int(random.integers(2, 6))):
        radius, half = float(random.uniform(0.5, 1.5)), float(random.uniform(30.0, 50.0))
        angle = layer * np.pi / 5.0 + float(random.uniform(-0.15, 0.15))
        height += radius + below if layer else 0.0
        along = half * np.array([np.cos(angle), np.sin(angle), 0.0])
        middle = np.array([*random.uniform(-3.0, 3.0, 2), height])
        spans = 2 * int(random.integers(8, 25))
        material = YarnMaterial.isotropic(float(10.0 ** random.uniform(2.0, 5.0)), 0.3)
        beams.append(Beam(straight(middle - along, middle + along, spans), radius, material))
        below = radius
    rods = Rods(beams, friction=float(random.choice([0.0, random.uniform(0.0, 1.0)])))
    for number in range(len(beams)):
        rods.clamp(number, [0, -1])
    return rods, random


def outcome(seed: float, fineness: float) -> Outcome:
    """Rods are pressed on those below them, then slid at random.

    Args:
        fineness: Increments of a few tenths of a radius, or all of the way in three.
    """
    rods, random = scene(int(seed))
    number, increments = len(rods.rods), 10 if fineness == FINE else 3
    watch = Watch(rods)
    for rod in range(1, number):
        rods.move(rod, [0, -1], by=(0.0, 0.0, -float(random.uniform(0.3, 1.5)) * rod))
    done = watch.solve(increments)
    for rod in range(1, number if done else 0):
        rods.move(rod, [0, -1], by=(*random.uniform(-4.0, 4.0, 2), 0.0))
    done and watch.solve(2 * increments)
    return watch.outcome(seed, fineness)


FAMILY = Family(
    "random",
    "Random scenes",
    ("seed", "increments"),
    (tuple(float(seed) for seed in range(20)), (COARSE, FINE)),
    outcome,
    "Two to five beams of random radii, moduli (100 MPa to 100 GPa), lengths, meshes, angles and friction lie above "
    "each other; they are pressed on each other and slid in random directions, in 3 and 6 or 10 and 20 increments.",
    logarithmic=(False, False),
    labels=("few", "many"),
    means=(
        "No answer is wrong. Those that fail say so, mostly because contacts come and go from one repetition "
        "of the pairing to the next; many increments do not mend them, but cut fewer. Held ends are not pushed "
        "into each other in any of them: that would be refused."
    ),
)
