"""(i) A twisted strand is pulled, let go and pushed: at rest, with a viscosity, and in motion."""

from __future__ import annotations

import numpy as np

from braidx.rods import Beam, Rods, Scheme, YarnMaterial, helix
from family import Family
from judge import Outcome, Watch

RADIUS, PITCH, TURNS, YARNS = 1.0, 40.0, 1.5, 3
PULL = 0.002  # strain
SOLVED, VISCOUS, MOVING = 0.0, 1.0, 2.0
VISCOSITY = 0.01  # N/mm per node
DENSITY, DURATION, STEPS = 8e-9, 0.1, 40  # t/mm^3, s


def strand(viscosity: float = 0.0, bundle_factor: float = 0.1) -> Rods:
    """Three yarns that touch each other, all ends clamped."""
    length, around = PITCH * TURNS, RADIUS * 2.0 / np.sqrt(3.0) * 1.02
    material = YarnMaterial.isotropic(10e3, 0.3)
    lines = [helix(around, PITCH, length, 60, 2.0 * np.pi * i / YARNS) for i in range(YARNS)]
    beams = [
        Beam(line, RADIUS, material, density=DENSITY, bundle_factor=bundle_factor) for line in lines
    ]
    rods = Rods(beams, friction=0.1, viscosity=viscosity)
    for yarn in range(YARNS):
        rods.clamp(yarn, [0, -1])
    return rods


def outcome(push: float, way: float) -> Outcome:
    """Pulled by a strain, back, and pushed by another.

    Args:
        push: Strain.
        way: Solved, with a viscosity or in motion.
    """
    rods = strand(VISCOSITY if way == VISCOUS else 0.0)
    return pulled_and_pushed(rods, (push, way), push, way == MOVING)


def pulled_and_pushed(
    rods: Rods, case: tuple[float, ...], push: float, moving: bool = False
) -> Outcome:
    """A strand is pulled by a strain, let go, and pushed by another."""
    watch = Watch(rods, conserves=False)
    for strain, increments in ((PULL, 2), (-PULL, 2), (-push, max(4, round(push / 0.0025)))):
        for yarn in range(YARNS):
            rods.move(yarn, -1, by=(0.0, 0.0, strain * PITCH * TURNS))
        if moving:
            steps = STEPS if strain == -push else 4
            done = watch.run(DURATION, DURATION / steps, scheme=Scheme.backward_euler())
        else:
            done = watch.solve(increments)
        if not done:
            break
    widest = max(
        float(np.linalg.norm(rods.positions(i)[:, :2], axis=1).max()) for i in range(YARNS)
    )
    return watch.outcome(*case, widest=widest / RADIUS)


FAMILY = Family(
    "birdcage",
    "A strand that is pushed",
    ("strain of compression", "how"),
    ((0.003, 0.01, 0.03, 0.1), (SOLVED, VISCOUS, MOVING)),
    outcome,
    "Three twisted yarns of a pitch and a half, clamped at their ends, are pulled by 0.2 %, let go, and pushed, with "
    "`solve`, with `solve` and a viscosity of 0.01 N/mm per node, and with `run` and `Scheme.backward_euler()`.",
    logarithmic=(True, False),
    labels=("solve", "viscosity", "run"),
    means=(
        "Three yarns open by `solve` alone, to 7.6 radii at 10 %. A viscosity and `run` find the same shape, "
        "to 0.0003 radii, with as many iterations or more."
    ),
)
