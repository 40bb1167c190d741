"""(f) Touching beams of which one has elements up to twenty times as long as the other's."""

from __future__ import annotations

from functools import cache

from family import Family
from judge import Outcome, Watch
from scenes import crossing, lift, press

FINE = 1.0  # length of the shorter elements over the radius


@cache
def pressed(lower: float, upper: float, angle: float) -> tuple[Outcome, float]:
    """Outcome, and force on the upper beam, N."""
    rods = crossing(angle, (lower, upper), friction=0.2)
    watch = Watch(rods)
    press(rods, watch)
    return watch.outcome(), lift(rods)


def outcome(ratio: float, angle: float) -> Outcome:
    """Elements of the lower beam over those of the upper one; below 1 the upper one's are the longer ones."""
    lengths = FINE * max(1.0, ratio), FINE * max(1.0, 1.0 / ratio)
    found, force = pressed(*lengths, angle)
    _, reference = pressed(FINE, FINE, angle)
    values = {"force over that of fine meshes": force / reference}
    return Outcome(**{**vars(found), "case": (ratio, angle), "values": values})


FAMILY = Family(
    "mismatch",
    "Meshes that do not match",
    ("length of elements below over that above", "crossing angle, degrees"),
    ((0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0), (3.0, 10.0, 30.0, 90.0)),
    outcome,
    "Beams that cross are pressed on each other by two radii with a friction of 0.2. The shorter elements are one "
    "radius long.",
    means=("Meshes of 1 : 20 neither cost iterations nor change forces by more than 0.7 %."),
)
