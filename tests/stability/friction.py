"""(b) Two beams that cross, pressed on each other and slid to and fro, against the coefficient of friction."""

from __future__ import annotations

from family import Family
from judge import Outcome, Watch
from scenes import SLIDE, crossing, drag, lift, press, slide


def outcome(friction: float, angle: float) -> Outcome:
    """Pressed, slid by six radii, back by twelve."""
    rods = crossing(angle, friction=friction)
    watch = Watch(rods)
    done = press(rods, watch) and slide(rods, watch, SLIDE, 12)
    ahead = drag(rods) / lift(rods)
    done = done and slide(rods, watch, -2 * SLIDE, 24)
    return watch.outcome(
        friction, angle, ahead=ahead, back=drag(rods) / lift(rods) if done else 0.0
    )


FAMILY = Family(
    "friction",
    "Friction and reversal",
    ("coefficient of friction", "crossing angle, degrees"),
    ((0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0), (5.0, 15.0, 30.0, 60.0, 90.0)),
    outcome,
    "Beams that cross are pressed on each other by two radii; then the ends of the upper one go along the lower one by "
    "six radii, and back by twelve, half a radius per increment.",
    logarithmic=(False, False),
    means=(
        "Coefficients up to 1 and reversals are safe, and drag over lift is the coefficient, within 0.015 "
        "from 30 degrees on. At 5 and 15 degrees it takes two to three times the iterations; slowest is 15 "
        "degrees without friction. Scenes of 5 to 30 degrees are called slow because the first increment of "
        "each motion is cut: half a radius would squeeze an element of four radii (two between nodes) by more "
        "than a fifth."
    ),
)
