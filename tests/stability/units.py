"""(e) The same scene in other units: lengths and forces are multiplied, answers without units are to stay."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from family import Family
from judge import CONVERGED, WRONG, Outcome, Watch
from scenes import SLIDE, crossing, drag, lift, press, slide

SAME = 1e-4  # relative


@cache
def answer(length: float, pressure: float) -> tuple[Outcome, float, float]:
    """Outcome, force over (modulus radius^2), and drag over lift of a scene pressed and slid."""
    rods = crossing(60.0, radius=length, modulus=1000.0 * pressure, friction=0.3)
    watch = Watch(rods)
    press(rods, watch) and slide(rods, watch, SLIDE, 12)
    force = lift(rods) / (1000.0 * pressure * length**2)
    return watch.outcome(length, pressure), force, drag(rods) / lift(rods)


def outcome(length: float, pressure: float) -> Outcome:
    """Compared with the scene in mm and MPa."""
    (found, *values), (_, *reference) = answer(length, pressure), answer(1.0, 1.0)
    pairs = zip(values, reference, strict=True)
    error = max(abs(value / expected - 1.0) for value, expected in pairs)
    found = replace(found, values={"error": error})
    if found.status == CONVERGED and error > SAME:
        return replace(found, status=WRONG, why=f"depends on units: {error:.1e}")
    return found


FAMILY = Family(
    "units",
    "Units",
    ("number that stands for a radius of 1 mm (1e-3: m, 1e3: µm)", "number for a modulus of 1 MPa"),
    ((1e-6, 1e-3, 1.0, 1e3, 1e6), (1e-6, 1e-3, 1.0, 1e3, 1e6)),
    outcome,
    "The scene of the penalties with default options, written in other units: MPa are 1e6 Pa or 1e-3 GPa. Forces "
    "over modulus and squared radius have to be the same to 1e-4.",
    means=(
        "Any consistent units do. They did not before this map was drawn: a tolerance of 0.005 mm made rods "
        "of 1e-3 mm overlap by 13 % of a diameter, without a word."
    ),
)
