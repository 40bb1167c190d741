"""(n) Overhand knots, tightened until they lock."""

from __future__ import annotations

import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

from family import Family
from judge import Outcome, Watch

sys.path.append(str(Path(__file__).parents[1] / "benchmark" / "peers"))
from knot import MODULUS, end_distance, overhand_knot  # noqa: E402

LENGTH, RADIUS, SPANS = 400.0, 1.6, 200  # mm, mm, of 1.25 radii each
LOOSE = 180.0  # length in the loose knot, radii
LEFT = (120.0, 80.0, 60.0, 40.0, 30.0, 20.0)  # and while it is tightened
PER_RADIUS = 0.5  # increments per radius that an end travels
BALANCE = 1e-3  # of what presses the knot on itself, which is far more than what pulls it
FRICTIONS = (0.0, 0.1, 0.5)


@cache
def tightened(friction: float) -> list[Outcome]:
    """A knot tightened in stages; the last one may have failed."""
    knot = overhand_knot(LENGTH - LOOSE * RADIUS, RADIUS, LENGTH, SPANS, friction)
    found: list[Outcome] = []
    for left in LEFT:
        watch = Watch(knot, balance=BALANCE)
        by = (LENGTH - left * RADIUS - end_distance(knot)) / 2.0
        for node, way in ((0, -by), (-1, by)):
            knot.move(0, node, by=(way, 0.0, 0.0))
        done = watch.solve(max(2, round(PER_RADIUS * by / RADIUS)))
        force = knot.reaction(0, -1)[0][0] / (MODULUS * RADIUS**2)
        found.append(watch.outcome(friction, left, force=float(force)))
        if not done:
            break
    return found


def outcome(friction: float, left: float) -> Outcome:
    """Of a stage; of those that were not come to, the failure before them."""
    found = tightened(friction)
    at = LEFT.index(left)
    return found[at] if at < len(found) else replace(found[-1], case=(friction, left), seconds=0.0)


FAMILY = Family(
    "knots",
    "Knots tightened to lock",
    ("coefficient of friction", "length left in the knot (radii)"),
    (FRICTIONS, LEFT),
    outcome,
    "An overhand knot in a soft rod, its ends moved apart, from loops that hold 180 radii of it to 20, where the "
    "rod is closer than round tubes could be, and is squeezed and stretched. Forces have to cancel to a thousandth "
    "of what presses the knot on itself, which is far more than what pulls it.",
    logarithmic=(False, True),
    means=(
        "Knots can be tightened until they lock, at 30 to 40 radii: the force (over modulus and squared radius) grows "
        "from 0.002 to 0.032 without friction, and to 0.1 with 0.5. Which of them get from 40 to 30 is a matter of "
        "chance: one machine found those with friction, another the one without. It is the dearest of all "
        "families: contacts along the crossing strands come and go from one repetition of the pairing to the next, and "
        "most increments are cut. Use short elements: with 1.6 radii, not 1.25 as here, knots stopped at 70 radii. "
        "Beyond the lock no equilibrium is found, with a message."
    ),
    together=len(LEFT),
)
