"""An overhand knot in a soft rod, pulled at its ends: the force against a peer's and against theory, and what it costs.

    ./braidx shell python3 tests/benchmark/peers/knot.py [--spans 240] [--increments 40] [--figure knot.png]

A rod of 1 m is tied to a loose knot, relaxed without friction, and its clamped ends are moved apart. The peer, an
implicit code of discrete elastic rods, moves them at 12 mm/s in steps of 2.5 ms; here each state is an equilibrium.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
from scipy.ndimage import gaussian_filter1d

from braidx.output.figures.style import AMBER, BLUE, GREY, figure, panels, save, styled
from braidx.rods import Beam, Rods, YarnMaterial

Floats = npt.NDArray[np.float64]

LENGTH, RADIUS, FRICTION = 1000.0, 1.6, 0.3  # mm, mm, -
MODULUS, POISSON = 0.18, 0.49  # MPa, -; the peer has 0.5, which the law of sections does not allow
LOOSE, TIGHT = 280.0, 520.0  # distance of the ends, mm
# Of the peer: distance of the ends (mm) and force (N) that pulls them.
PEER = np.array(
    [
        [304.0, 2.60e-4],
        [328.0, 2.17e-4],
        [352.0, 2.26e-4],
        [376.0, 2.92e-4],
        [400.0, 3.00e-4],
        [424.0, 3.11e-4],
        [448.0, 3.50e-4],
        [472.0, 4.15e-4],
        [496.0, 3.91e-4],
        [520.0, 4.15e-4],
    ]
)
PEER_COST = {"unknowns": 1203, "iterations": 16047, "seconds": 298.0}
BRAID = (
    7.0  # length of the braid of a loose knot over the geometric mean of the radii of rod and loop
)
CORNER = 0.05  # of the loop's radius: what the start is rounded over
SLACK = 6.0  # radii along the rod from which on it may touch itself
NOTE = {"textcoords": "offset points", "ha": "center", "fontsize": 7}
HALVINGS = 14  # of the viscosity while a knot comes to rest


def loop_radius(distance: float, length: float = LENGTH) -> float:
    """Of a circle of the length that the ends leave, mm."""
    return (length - distance) / (2.0 * np.pi)


def loose_line(distance: float, radius: float, length: float, num_spans: int) -> Floats:
    """Two straight tails along x, three half turns about each other, and a circle between them.

    Returns:
        Nodes, shape (num_spans + 1, 3), mm.
    """
    braid = BRAID * np.sqrt(radius * loop_radius(distance, length))
    turn = np.linspace(0.0, 3.0 * np.pi, 1000)
    apart = 1.15 * radius  # of strand and axis, so that rounding does not bring them together
    x = braid * (turn / turn[-1] - 0.5)
    first = np.stack([x, -apart * np.cos(turn), -apart * np.sin(turn)], axis=1)
    second = first * [1.0, -1.0, -1.0]

    def whole(loop: float) -> Floats:
        beside = np.arcsin(braid / 2.0 / loop)
        angle = np.linspace(beside, 2.0 * np.pi - beside, 4000) - np.pi / 2.0
        height = apart + loop * np.cos(beside)
        ring = np.stack([loop * np.cos(angle), height + loop * np.sin(angle), 0 * angle], axis=1)
        end = np.array([[distance / 2.0, -apart, 0.0]])
        return np.concatenate([end * [-1.0, 1.0, 1.0], first, ring[1:-1], second, end])

    def line(loop: float) -> Floats:
        return _rounded(whole(loop), CORNER * loop, num_spans)

    low, high = 0.51 * braid, length
    while high - low > 1e-6 * length:
        middle = 0.5 * (low + high)
        chords = np.linalg.norm(np.diff(line(middle), axis=0), axis=1)
        low, high = (middle, high) if chords.sum() < length else (low, middle)
    return line(low)


def _rounded(line: Floats, over: float, num_spans: int) -> Floats:
    """Nodes, about equally far from each other, of a line whose corners are rounded; its ends stay."""
    arc = np.append(0.0, np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum())
    fine = np.linspace(0.0, arc[-1], 8 * num_spans + 1)
    points = np.stack([np.interp(fine, arc, component) for component in line.T], axis=1)
    smooth = gaussian_filter1d(points, over / fine[1], axis=0, mode="nearest")
    share = np.clip(np.minimum(fine, fine[-1] - fine) / (4.0 * over), 0.0, 1.0)[:, None]
    return np.asarray((share * smooth + (1.0 - share) * points)[::8])


def overhand_knot(
    distance: float = LOOSE,
    radius: float = RADIUS,
    length: float = LENGTH,
    num_spans: int = 240,
    friction: float = FRICTION,
) -> Rods:
    """A loose knot at rest, its ends clamped along x; friction acts from now on.

    Args:
        distance: Of the ends, mm.
        radius, length: Of the rod, mm.
        num_spans: Between nodes.
        friction: Coefficient.
    """
    loop = loop_radius(distance, length)
    # Under the force per length that the strands of a loose knot exert on each other, a hundredth of the radius deep.
    penalty = 1700.0 * MODULUS * (radius / loop) ** 2.5
    rod = Beam(
        loose_line(distance, radius, length, num_spans),
        radius,
        YarnMaterial.isotropic(MODULUS, POISSON),
        degree=1,
        natural_state="straight",
    )
    knot = Rods([rod], self_contact=SLACK, penalty=penalty, tolerance=1e-6)
    knot.contact.laws.regularisation = 0.01 * radius
    knot.clamp(0, [0, -1])
    positions = ~knot.layout.is_director
    bending = MODULUS * np.pi * radius**4 / 4.0
    viscosity = 400.0 * bending * length / num_spans / loop**4  # N/mm per node
    for _ in range(HALVINGS):
        knot.proximal.viscosity[positions] = viscosity
        knot.solve()
        viscosity /= 2.0
    knot.proximal.viscosity[:] = 0.0
    knot.friction_of(0, friction)
    return knot


def end_distance(knot: Rods) -> float:
    """Of the ends, mm."""
    line = knot.positions(0)
    return float(np.linalg.norm(line[-1] - line[0]))


@dataclass(frozen=True)
class Outcome:
    """Distance of the ends (mm) and force that pulls them (N), shape (n, 2), and cost with one thread."""

    curve: Floats
    unknowns: int
    increments: int
    iterations: int
    updates: int
    seconds: float
    megabytes: float

    def force(self, distance: Floats) -> Floats:
        """Force at distances of the ends, N."""
        return np.interp(distance, *self.curve.T)


def tighten(knot: Rods, distance: float, increments: int) -> Outcome:
    """Moves both ends apart until they have a distance, mm.

    Raises:
        NotConverged: If it does not get there; the knot stays where it got.
    """
    begin, curve = time.process_time(), []
    half = 0.5 * (distance - end_distance(knot))
    knot.move(0, -1, by=(half, 0.0, 0.0))
    knot.move(0, 0, by=(-half, 0.0, 0.0))

    def observe(share: float) -> None:
        curve.append([end_distance(knot), knot.reaction(0, -1)[0][0]])

    done = knot.solve(increments, observe=observe)
    return Outcome(
        np.array(curve),
        knot.q.size,
        len(done),
        sum(increment.iterations for increment in done),
        sum(increment.updates for increment in done),
        time.process_time() - begin,
        resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    )


def asymptotic_force(
    distance: Floats, friction: float, radius: float = RADIUS, length: float = LENGTH
) -> Floats:
    """Force on a loose knot with long tails, N: exact where friction and the root of radius over loop radius are small.

    Audoly, Clauvelin, Neukirch: Elastic knots. Phys. Rev. Lett. 99 (2007) 164301; the term of friction, for an overhand
    knot that is tightened, as the peer states it from their later work.
    """
    ratio = np.sqrt(radius / loop_radius(np.asarray(distance), length))
    bending = MODULUS * np.pi * radius**4 / 4.0
    return np.asarray(bending / radius**2 * (0.5 * ratio**4 + 0.492 * friction * ratio**3))


def run(num_spans: int = 240, increments: int = 40, friction: float = FRICTION) -> Outcome:
    """The scene of the peer; costs are those of all of it but iterations, which are those of tightening."""
    begin = time.process_time()
    outcome = tighten(overhand_knot(num_spans=num_spans, friction=friction), TIGHT, increments)
    return replace(outcome, seconds=time.process_time() - begin)


@styled
def draw(outcomes: Sequence[Outcome], path: Path) -> Path:
    """Force over distance, the last outcome and the peer's; seconds over unknowns, all outcomes and the peer's."""
    page = figure(8.5, 3.4)
    left, right = panels(page, 1, 2)
    distance, force = outcomes[-1].curve.T
    left.plot(
        distance, 1e6 * force, color=BLUE, label=f"braidx, {outcomes[-1].unknowns:,} unknowns"
    )
    left.plot(*(PEER * [1.0, 1e6]).T, "o", color=AMBER, ms=4, label="imc-der, 1,203 unknowns")
    loose = asymptotic_force(distance, FRICTION)
    left.plot(distance, 1e6 * loose, "--", color=GREY, label="loose knot, little friction: theory")
    left.set(xlabel="distance of the ends (mm)", ylabel="force (µN)", ylim=(0.0, None))
    left.set_title("Force that tightens the knot")
    left.legend(fontsize=8)
    unknowns = [outcome.unknowns for outcome in outcomes]
    right.plot(
        unknowns, [outcome.seconds for outcome in outcomes], "o-", color=BLUE, label="braidx"
    )
    right.plot(PEER_COST["unknowns"], PEER_COST["seconds"], "o", color=AMBER, label="imc-der")
    for outcome in outcomes:
        label = f"{outcome.iterations:,}"
        right.annotate(label, (outcome.unknowns, outcome.seconds), (0, -14), **NOTE)
    label = f"{PEER_COST['iterations']:,.0f}"
    right.annotate(label, (PEER_COST["unknowns"], PEER_COST["seconds"]), (0, 7), **NOTE)
    right.set(xlabel="unknowns", ylabel="processor time (s)", yscale="log", ylim=(1.0, 1000.0))
    right.set(xlim=(0.0, 1.15 * max(unknowns)))
    right.set_title("Cost, one thread; numbers: Newton iterations")
    right.legend(fontsize=8, loc="upper right")
    return save(page, path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spans", type=int, nargs="+", default=[160, 240, 320])
    parser.add_argument("--increments", type=int, default=40)
    parser.add_argument("--figure", type=Path)
    words = parser.parse_args()
    print("| unknowns | force over the peer's, mean and each | iterations | updates | s | MB |")
    print("|" + " ---: |" * 6)
    outcomes = [run(spans, words.increments) for spans in words.spans]
    for o in outcomes:
        ratio = o.force(PEER[:, 0]) / PEER[:, 1]
        print(
            f"| {o.unknowns} | {ratio.mean():.3f}: {' '.join(f'{r:.2f}' for r in ratio)} "
            f"| {o.iterations} | {o.updates} | {o.seconds:.1f} | {o.megabytes:.0f} |",
            flush=True,
        )
    if words.figure:
        draw(outcomes, words.figure)


if __name__ == "__main__":
    main()
