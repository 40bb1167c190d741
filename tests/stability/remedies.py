"""What helps where beams cross at a small angle, the slowest of these scenes: options against each other."""

from __future__ import annotations

from collections.abc import Callable

from braidx.rods import Beam, Rods, Scheme
from family import Family
from judge import Outcome, Watch
from scenes import PRESS, crossing, lift, press

ELEMENT, DENSITY = 4.0, 1e-9  # radii, t/mm^3


def _solved(increments: int, **options: float) -> Callable[[float], Watch]:
    def attempt(angle: float) -> Watch:
        rods = crossing(angle, (ELEMENT, ELEMENT), **options)
        watch = Watch(rods)
        press(rods, watch, increments)
        return watch

    return attempt


def _moving(angle: float) -> Watch:
    still = crossing(angle, (ELEMENT, ELEMENT))
    beams = [Beam(rod.line, rod.radius, rod.material, density=DENSITY) for rod in still.rods]
    rods = Rods(beams)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    watch = Watch(rods, conserves=False)
    rods.move(1, [0, -1], by=(0.0, 0.0, -PRESS))
    watch.run(0.4, 0.1, scheme=Scheme.backward_euler())
    return watch


REMEDIES: tuple[tuple[str, Callable[[float], Watch]], ...] = (
    ("none", _solved(4)),
    ("16 increments", _solved(16)),
    ("viscosity 1e-3 N/mm", _solved(4, viscosity=1e-3)),
    ("penalty 0.01 E", _solved(4, penalty=10.0)),
    ("tolerance 1e-6", _solved(4, tolerance=1e-6)),
    ("stations half as far", _solved(4, spacing=1.0)),
    ("run, 4 steps", _moving),
)


def outcome(angle: float, remedy: float) -> Outcome:
    """Pressed by two radii with the remedy of this number."""
    watch = REMEDIES[int(remedy)][1](angle)
    return watch.outcome(angle, remedy, lift=lift(watch.rods))


FAMILY = Family(
    "remedies",
    "Remedies at small angles",
    ("crossing angle, degrees", "remedy"),
    ((1.0, 2.0, 5.0, 20.0), tuple(float(number) for number in range(len(REMEDIES)))),
    outcome,
    "The scene of the crossing angles with elements of four radii, and what might help: "
    + ", ".join(f"{number}: {name}" for number, (name, _) in enumerate(REMEDIES))
    + ". The default penalty is the modulus E, the default of stations two radii here.",
    logarithmic=(True, False),
    labels=tuple(name for name, _ in REMEDIES),
    means=(
        "A penalty of a hundredth of the modulus halves the iterations at 1 to 5 degrees, where pressures are "
        "small; at 20 degrees it doubles them. More increments, a lower tolerance, denser stations and motion "
        "help nothing. A viscosity costs up to three times the iterations: it holds what contact should, and "
        "lets go of it before an equilibrium counts. Before it did, it took more work than the beams at 1 degree."
    ),
)
