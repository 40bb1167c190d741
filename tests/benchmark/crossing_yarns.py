"""Two crossing yarns of solids, pressed onto each other and slid with friction: forces and what they cost.

    ./braidx shell python3 tests/benchmark/crossing_yarns.py [--seeds 8 12]

Both ends of the lower yarn are held; those of the upper one move down by 0.5 mm, then along its axis by 1.5 mm. The
section is an o-grid of two rings; 8 seeds round it make 4200 unknowns, 12 make 9546.
"""

from __future__ import annotations

import argparse
import resource
import time
from dataclasses import dataclass

import numpy as np

from braidx.meshing import round_section
from braidx.rods import Rods, Solid, YarnMaterial, straight

RADIUS, LENGTH = 1.0, 10.0  # mm
MATERIAL, FRICTION = YarnMaterial.isotropic(1000.0, 0.3), 0.2
PRESS, SLIDE = 0.5, 1.5  # mm
INCREMENTS = (10, 20)  # of pressing and sliding
LOWER, UPPER = 0, 1
ENDS = [0, -1]


@dataclass(frozen=True)
class Outcome:
    """Forces on the upper yarn when pressed and at the end, N, positive against the motion, and cost."""

    unknowns: int
    pressed: float
    normal: float
    tangential: float
    iterations: int
    updates: int
    seconds: float
    megabytes: float  # the most that the process has taken so far


def yarn(seeds: int, axis: int, height: float) -> Solid:
    """A straight yarn along x (axis 0) or y (1), with a row of nodes along its top and bottom."""
    half = 0.5 * LENGTH * np.eye(3)[axis]
    line = straight(-half, half, 3 * seeds) + [0.0, 0.0, height]
    directors = [np.eye(3)[2], np.cross(np.eye(3)[axis], np.eye(3)[2])]
    return Solid(
        line,
        RADIUS,
        MATERIAL,
        round_section(RADIUS, seeds, rings=2),
        np.broadcast_to(directors, (len(line), 2, 3)),
        law="Saint-Venant-Kirchhoff",
    )


def crossing(seeds: int) -> Rods:
    """The two yarns, their ends clamped."""
    yarns = [yarn(seeds, 0, 0.0), yarn(seeds, 1, 2.0 * RADIUS)]
    rods = Rods(
        yarns,
        friction=FRICTION,
        penalty=20.0 * MATERIAL.axial_modulus,
        penetration=None,
        tolerance=1e-6,
    )
    rods.contact.laws.regularisation = rods.contact.laws.reversible_slip = 1e-3 * RADIUS
    for number in (LOWER, UPPER):
        rods.clamp(number, ENDS)
    return rods


def force(rods: Rods) -> np.ndarray:
    """That holds the ends of the upper yarn, shape (3,), N."""
    return rods.resultant([(UPPER, end) for end in ENDS], about=np.zeros(3))[0]


def run(
    seeds: int, press: float = PRESS, slide: float = SLIDE, increments: tuple[int, int] = INCREMENTS
) -> Outcome:
    """Presses and slides in equal increments."""
    start = time.perf_counter()
    rods = crossing(seeds)
    rods.move(UPPER, ENDS, by=(0.0, 0.0, -press))
    done = rods.solve(increments[0])
    pressed = -force(rods)[2]
    rods.move(UPPER, ENDS, by=(0.0, slide, 0.0))
    done += rods.solve(increments[1])
    _, tangential, upward = force(rods)
    return Outcome(
        rods.q.size,
        float(pressed),
        float(-upward),
        float(tangential),
        sum(increment.iterations for increment in done),
        sum(increment.updates for increment in done),
        time.perf_counter() - start,
        resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, nargs="+", default=[8, 12])
    print(
        "| unknowns | pressed (N) | normal (N) | tangential (N) | iterations | updates | s | MB |"
    )
    print("|" + " ---: |" * 8)
    for seeds in parser.parse_args().seeds:
        o = run(seeds)
        print(
            f"| {o.unknowns} | {o.pressed:.2f} | {o.normal:.2f} | {o.tangential:.2f} "
            f"| {o.iterations} | {o.updates} | {o.seconds:.1f} | {o.megabytes:.0f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
