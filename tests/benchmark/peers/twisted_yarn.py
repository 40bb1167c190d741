"""A yarn of straight fibres whose clamped ends are turned against each other: forces against theory, and what it costs.

    ./braidx shell python3 tests/benchmark/peers/twisted_yarn.py [--increments 12] [--figure forces.png]

The three scenes of a peer, an implicit code with barriers for contact and without bending stiffness: 7 fibres of 40
spans in 4 turns, 19 of 40 in 2, 19 of 80 in 4. Fibres are cables here, too.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

from braidx.output.figures.style import AMBER, BLUE, GREY, figure, panels, save, styled
from braidx.rods import Cable, Rods, straight

Floats = npt.NDArray[np.float64]

RADIUS, LENGTH, STIFFNESS, TENSION, FRICTION = 0.5, 150.0, 1000.0, 1.0, 0.2  # mm, mm, N, N, -
FIT = 1.01  # distance of neighbours over their diameter
AXIS = np.array([0.0, 0.0, 1.0])
SCENES = [(7, 40, 4.0), (19, 40, 2.0), (19, 80, 4.0)]  # fibres, spans, turns
PEER = {(7, 40): 3.1, (19, 40): 6.5}  # seconds of the peer, which stalls on the third


def hexagonal(count: int) -> Floats:
    """Places of fibres around one in the middle, layer by layer, shape (count, 2), in distances of neighbours."""
    corner = np.stack([np.cos(np.pi / 3 * np.arange(7)), np.sin(np.pi / 3 * np.arange(7))], axis=1)
    places, layer = [np.zeros(2)], 1
    while len(places) < count:
        for side in range(6):
            step = (corner[side + 1] - corner[side]) * np.arange(layer)[:, None]
            places += list(layer * corner[side] + step)
        layer += 1
    return np.array(places[:count])


def yarn(fibres: int, spans: int) -> Rods:
    """Straight fibres under a little tension, their ends pinned."""
    places = 2.0 * RADIUS * FIT * hexagonal(fibres)
    cables = [
        Cable(straight((x, y, 0), (x, y, LENGTH), spans), RADIUS, STIFFNESS, TENSION, degree=1)
        for x, y in places
    ]
    rods = Rods(cables, friction=FRICTION, tolerance=1e-6)
    # Contact that sets in over a hundredth of the radius: fibres lie beside each other all along.
    rods.contact.laws.regularisation = 0.01 * RADIUS
    for fibre in range(fibres):
        rods.pin(fibre, [0, -1])
    return rods


def spun(line: Floats, turn: float) -> Floats:
    """A line whose places turn about the axis, in proportion to their height, by `turn` between its ends."""
    angle = turn * (np.linspace(0.0, 1.0, len(line)) - 0.5)
    return np.asarray(Rotation.from_rotvec(angle[:, None] * AXIS).apply(line))


@dataclass(frozen=True)
class Outcome:
    """Turns, tension (N) and torque (N mm) of the yarn, shape (n, 3), and cost with one thread.

    Attributes:
        radii: Distance of the middle of each fibre from the axis at the end, shape (num_fibres,), mm.
    """

    fibres: int
    spans: int
    curve: Floats
    radii: Floats
    unknowns: int
    iterations: int
    updates: int
    seconds: float
    megabytes: float


def twist(rods: Rods, turns: float, increments: int) -> Outcome:
    """Turns the ends against each other, in equal increments.

    Each is sought from where the yarn comes to if it goes on as in the one before, seen by what turns with it.

    Raises:
        NotConverged: If there is no equilibrium; the yarn stays where it got.
    """
    begin, count = time.process_time(), len(rods.rods)
    step = 2.0 * np.pi * turns / increments
    unwound = before = [rods.positions(fibre) for fibre in range(count)]
    curve, done = [[0.0, *_ends(rods)]], []
    for number in range(1, increments + 1):
        for fibre in range(count):
            rods.move(fibre, 0, turn=-0.5 * step * AXIS, about=(0, 0, 0))
            rods.move(fibre, -1, turn=0.5 * step * AXIS, about=(0, 0, LENGTH))
        guess = {i: spun(2.0 * unwound[i] - before[i], step * number) for i in range(count)}
        done += rods.solve(guess=guess)
        before = unwound
        unwound = [spun(rods.positions(fibre), -step * number) for fibre in range(count)]
        curve.append([turns * number / increments, *_ends(rods)])
    middles = np.array([rods.positions(fibre)[len(before[0]) // 2, :2] for fibre in range(count)])
    return Outcome(
        count,
        len(before[0]) - 1,
        np.array(curve),
        np.linalg.norm(middles, axis=1),
        rods.q.size,
        sum(increment.iterations for increment in done),
        sum(increment.updates for increment in done),
        time.process_time() - begin,
        resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    )


def _ends(rods: Rods) -> tuple[float, float]:
    """Tension and torque of the yarn."""
    ends = [(fibre, -1) for fibre in range(len(rods.rods))]
    force, moment = rods.resultant(ends, about=(0.0, 0.0, LENGTH))
    return float(force[2]), float(moment[2])


def helices(turns: Floats, radii: Floats) -> tuple[Floats, Floats]:
    """Tension (N) and torque (N mm) of fibres that are helices of one pitch and keep their radii.

    A fibre that turns by a over the length is stretched by the square of l = sqrt(1 + (a r / L)^2). The force along it
    is l (T0 + EA (l^2 - 1) / 2), 1 / l of it along the axis, and a r / (L l) across.

    Args:
        radii: Of the helices, shape (num_fibres,), mm.
    """
    rate = 2.0 * np.pi * np.asarray(turns)[..., None] / LENGTH
    along = TENSION + 0.5 * STIFFNESS * (rate * radii) ** 2
    return along.sum(axis=-1), (along * rate * radii**2).sum(axis=-1)


@styled
def draw(outcomes: Sequence[Outcome], path: Path) -> Path:
    """Tension and torque over turns, beside those of helices, and processor time over unknowns."""
    page = figure(9.5, 3.4)
    places = panels(page, 1, 3)
    for outcome, colour in zip(outcomes, (BLUE, GREY, AMBER), strict=False):
        name = f"{outcome.fibres} × {outcome.spans}"
        turns, *found = outcome.curve.T
        theory = helices(turns, outcome.radii)
        for ax, value, exact in zip(places, found, theory, strict=False):
            ax.plot(turns, value, "o", ms=3, color=colour, label=name)
            ax.plot(turns, exact, "-", lw=1, color=colour)
        places[2].plot(outcome.unknowns, outcome.seconds, "o", color=colour, label=name)
    places[0].set(xlabel="turns", ylabel="tension (N)", title="Tension; lines: helices")
    places[1].set(xlabel="turns", ylabel="torque (N mm)", title="Torque; lines: helices")
    places[2].set(xlabel="unknowns", ylabel="processor time (s)", title="Cost, one thread")
    places[2].set(xlim=(0.0, None), ylim=(0.0, None))
    places[0].legend(title="fibres × spans", fontsize=8, title_fontsize=8)
    return save(page, path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--increments", type=int, default=12)
    parser.add_argument("--figure", type=Path)
    parser.add_argument("--picture", type=Path)
    words = parser.parse_args()
    print("| fibres | turns | unknowns | tension | torque | iterations | updates | s | MB | peer |")
    print("|" + " ---: |" * 10)
    outcomes = []
    for fibres, spans, turns in SCENES:
        rods = yarn(fibres, spans)
        o = twist(rods, turns, words.increments)
        outcomes.append(o)
        tension, torque = o.curve[-1, 1:] / helices(turns, o.radii)
        peer = f"{PEER[fibres, spans]} s" if (fibres, spans) in PEER else "stalls"
        print(
            f"| {fibres} x {spans} | {turns:g} | {o.unknowns} | {tension:.3f} | {torque:.3f} | {o.iterations} "
            f"| {o.updates} | {o.seconds:.1f} | {o.megabytes:.0f} | {peer} |",
            flush=True,
        )
    if words.figure:
        draw(outcomes, words.figure)
    if words.picture:
        rods.draw(words.picture, towards=(1.0, 0.2, 0.1), up=(0.0, 1.0, 0.0))


if __name__ == "__main__":
    main()
