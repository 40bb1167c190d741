"""A strand of round steel wires under tension, bent and bent back with friction: moments, and what they cost.

    ./braidx shell python3 tests/benchmark/peers/strand.py 7 19 37 61 91 [--back --figure strand.png]

A straight king wire in layers of 6, 12, 18... helical ones, to the right and to the left by turns, all at the same
angle. Wires are free of stress as placed. At one end (z = LENGTH) all are clamped in one rigid section; at the other
their sections are guided and the mean of their positions is held across the strand, but each wire may slide out, and is
pulled along its own axis by the same dead force. So the strand keeps its tension while it is bent, which two clamps
would not let it. The clamped section turns about the middle of the strand.

The moment lies between two bounds, those of a beam under the tension of the strand whose ends turn by half the angle
each: with the bending stiffness of wires that all stick, or of wires that all slip without friction. Source of both
stiffnesses: Papailiou, On the bending stiffness of transmission line conductors (1997).
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import numpy.typing as npt
from matplotlib.figure import Figure

from braidx.rods import Beam, NotConverged, Rods, YarnMaterial, helix, straight
from braidx.solver.increment import Increment

Floats = npt.NDArray[np.float64]

RADIUS, KING = 1.0, 1.08  # of wires; of the king wire, so that the first layer does not jam, mm
LENGTH, LAY = 60.0, 60.0  # of the strand; pitch of layer k over k, mm
ELEMENTS = (8, 8, 6)  # of degree 2, of the king wire and of wires of layers 1 and 2
FEWER = 4  # of wires of other layers, which turn less along the strand
MODULUS, POISSON, FRICTION = 200e3, 0.3, 0.15  # MPa
TENSION = 200.0  # of each wire, N
ANGLE = 0.5  # radians
# Contact sets in gradually, as that of round steel wires does: 20 N/mm press them 4.5 micrometres into each other, and
# layers are placed so that this is about where they begin.
PENALTY, REGULARISATION, FIT = 0.1 * MODULUS, 1e-2, 5e-3  # N/mm per mm, mm, mm
PATIENCE = 5  # Newton steps: contacts of wires that begin to slip open and close by turns
STICKING = (0.001, 0.01)  # radians: first angles, to see wires begin to slip
STEP = 0.17  # of the others
AREA, INERTIA = np.pi * RADIUS**2, np.pi * RADIUS**4 / 4.0


def layer_radius(layer: int) -> float:
    """Of its centre lines, mm."""
    return KING + (2 * layer - 1) * RADIUS - layer * FIT


def num_layers(wires: int) -> int:
    """Layers about the king wire.

    Raises:
        ValueError: If the outermost layer would not be full.
    """
    layers = round((np.sqrt((4 * wires - 1) / 3) - 1) / 2)
    if wires != 1 + 3 * layers * (layers + 1):
        raise ValueError(f"{wires} wires do not fill their layers; give 7, 19, 37, 61, 91...")
    return layers


@dataclass
class Outcome:
    """What was found, and what it cost.

    Attributes:
        angles, moments: Radians and N mm (about the axis of bending), at the clamp, of all equilibria.
        slipping, sticking: Bounds of the moments, N mm.
        penetration: The deepest, mm.
        cpu, wall: Seconds of the process, and as time passed. Like all numbers before them until the largest angle.
    """

    wires: int
    unknowns: int
    angles: Floats
    moments: Floats
    slipping: Floats
    sticking: Floats
    increments: int
    iterations: int
    updates: int
    penetration: float
    cpu: float
    wall: float


@dataclass
class Strand:
    """The scene; `rods` can be looked at between calls."""

    wires: int
    rods: Rods = field(init=False)
    angle: float = 0.0

    def __post_init__(self) -> None:
        steel = YarnMaterial.isotropic(MODULUS, POISSON)
        parts = [Beam(straight((0, 0, 0), (0, 0, LENGTH), 2 * ELEMENTS[0]), KING, steel)]
        pulls = [np.array([0.0, 0.0, -TENSION])]
        for layer in range(1, num_layers(self.wires) + 1):
            radius, pitch = layer_radius(layer), (-1) ** (layer + 1) * LAY * layer
            spans = 2 * (ELEMENTS[layer] if layer < len(ELEMENTS) else FEWER)
            for phase in np.linspace(0.0, 2.0 * np.pi, 6 * layer, endpoint=False):
                parts.append(Beam(helix(radius, pitch, LENGTH, spans, phase), RADIUS, steel))
                slope = 2.0 * np.pi * radius / pitch
                tangent = np.array([-slope * np.sin(phase), slope * np.cos(phase), 1.0])
                pulls.append(-TENSION * tangent / np.linalg.norm(tangent))
        rods = self.rods = Rods(
            parts, friction=FRICTION, penalty=PENALTY, tolerance=1e-6, patience=PATIENCE
        )
        rods.contact.laws.regularisation = REGULARISATION
        for wire, pull in enumerate(pulls):
            rods.clamp(wire, -1)
            rods.hold(wire, 0, slice(3, 9))
            rods.force(wire, 0, pull)
        rods.hold_mean([(wire, 0) for wire in range(self.wires)], [0, 1])
        self.pull = -float(sum(pull[2] for pull in pulls))

    def bend(
        self, angle: float, increments: int, observe: Callable[[float], None]
    ) -> list[Increment]:
        """Turns the clamped section to an angle, radians; observe: see Rods.solve."""
        for wire in range(self.wires):
            turn = (0.0, angle - self.angle, 0.0)
            self.rods.move(wire, -1, turn=turn, about=(0.0, 0.0, LENGTH / 2.0))
        self.angle = angle
        return self.rods.solve(increments, observe=observe)

    def moment(self) -> float:
        """At the clamp, about the axis of bending and the centre of the section, N mm."""
        clamp = [(wire, -1) for wire in range(self.wires)]
        return float(self.rods.resultant(clamp, self.rods.positions(0)[-1])[1][1])

    def stiffness(self, stick: bool) -> float:
        """In bending, of wires that slip without friction or of a strand that sticks, N mm^2."""
        total = MODULUS * INERTIA * (KING / RADIUS) ** 4
        for layer in range(1, num_layers(self.wires) + 1):
            radius = layer_radius(layer)
            cosine = 1.0 / np.hypot(1.0, 2.0 * np.pi * radius / (LAY * layer))
            own, steiner = INERTIA * cosine, AREA * radius**2 / 2.0 * cosine**3
            total += 6 * layer * MODULUS * (own + (steiner if stick else 0.0))
        return total

    def bound(self, stick: bool) -> float:
        """Moment at the ends of a beam of this stiffness under the tension, per radian between them, N mm."""
        wave = np.sqrt(self.pull / self.stiffness(stick))
        return float(self.stiffness(stick) * wave / np.tanh(wave * LENGTH / 2.0) / 2.0)


class Measured:
    """A strand on its way, with angles (radians) and moments (N mm) of all equilibria, and their increments."""

    def __init__(self, wires: int) -> None:
        self.strand = Strand(wires)
        self.increments = self.strand.rods.solve()
        self.angles, self.moments = [0.0], [self.strand.moment()]

    def bend(self, angle: float, step: float) -> None:
        """To an angle: in small increments until wires slip, then in steps."""
        begin, way = self.strand.angle, angle - self.strand.angle
        for part in STICKING:
            if part < abs(way):
                self._follow(begin + np.sign(way) * part, 1)
        self._follow(angle, max(1, round(abs(way) / step)))

    def _follow(self, angle: float, increments: int) -> None:
        begin = self.strand.angle

        def observe(share: float) -> None:
            self.angles.append(begin + share * (angle - begin))
            self.moments.append(self.strand.moment())

        self.increments += self.strand.bend(angle, increments, observe)


def run(wires: int, angle: float = ANGLE, step: float = STEP, back: bool = False) -> Outcome:
    """Pulls and bends, and bends back if asked for, which is not in the cost."""
    wall, cpu = time.perf_counter(), time.process_time()
    measured = Measured(wires)
    measured.bend(angle, step)
    cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
    done, strand = list(measured.increments), measured.strand
    if back:
        measured.bend(0.0, step)
    angles = np.array(measured.angles)
    return Outcome(
        wires,
        strand.rods.q.size,
        angles,
        np.array(measured.moments),
        strand.bound(stick=False) * angles,
        strand.bound(stick=True) * angles,
        len(done),
        sum(increment.iterations for increment in done),
        sum(increment.updates for increment in done),
        max(increment.penetration for increment in done),
        cpu,
        wall,
    )


def draw(outcomes: list[Outcome], path: Path) -> None:
    """Moments over angles, a panel for each strand."""
    figure = Figure(figsize=(3.2 * len(outcomes), 3.4), layout="constrained")
    for axes, o in zip(np.ravel(figure.subplots(1, len(outcomes))), outcomes, strict=True):
        end = int(np.argmax(o.angles))
        slip = [0.0, o.slipping[end] / 1e3]
        axes.plot([0.0, o.angles[end]], slip, "k--", lw=1.0, label="all wires slip freely")
        top = 1.15 * float(o.moments.max())
        reach = top / (o.sticking / np.where(o.angles, o.angles, 1.0)).max()
        axes.plot([0.0, reach], [0.0, top / 1e3], "k:", lw=1.0, label="all wires stick")
        axes.plot(o.angles, o.moments / 1e3, "o-", ms=2.5, lw=1.2, label="computed")
        axes.set(title=f"{o.wires} wires", xlabel="angle (rad)", ylabel="moment at the clamp (N m)")
        axes.set_ylim(top=top / 1e3)
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=120)


HEAD = (
    "| wires | unknowns | increments | Newton iterations | contact updates | CPU (s) | wall (s) "
    "| moment (N m) | over the slip bound | penetration / radius |"
)


def row(o: Outcome) -> str:
    """Of the table, up to the largest angle."""
    end = int(np.argmax(o.angles))
    return (
        f"| {o.wires} | {o.unknowns} | {o.increments} | {o.iterations} | {o.updates} | {o.cpu:.1f} "
        f"| {o.wall:.1f} | {o.moments[end] / 1e3:.2f} | {o.moments[end] / o.slipping[end]:.3f} "
        f"| {o.penetration / RADIUS:.4f} |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("wires", type=int, nargs="*", default=[7, 19, 37, 61, 91])
    parser.add_argument("--back", action="store_true", help="bend back to straight, too")
    parser.add_argument("--figure", type=Path, help="where to draw moments over angles")
    parser.add_argument("--curve", action="store_true", help="print moments at all angles")
    given = parser.parse_args()
    print(HEAD + "\n" + "|" + " ---: |" * (HEAD.count("|") - 1))
    outcomes = []
    for wires in given.wires:
        try:
            outcomes.append(run(wires, back=given.back))
        except NotConverged as failure:
            print(f"| {wires} | not converged: {failure} |", flush=True)
            continue
        print(row(outcomes[-1]), flush=True)
        if given.curve:
            o = outcomes[-1]
            for values in zip(o.angles, o.moments, o.slipping, o.sticking, strict=True):
                print("    {:.4f} rad: {:.1f} N mm, bounds {:.1f} and {:.1f}".format(*values))
    if given.figure and outcomes:
        draw(outcomes, given.figure)


if __name__ == "__main__":
    main()
