"""(g) Pressed and slid with increments from small to a hundred times that."""

from __future__ import annotations

from functools import cache

from family import Family
from judge import Outcome, Watch
from scenes import SLIDE, crossing, drag, lift, press, slide


@cache
def slid(step: float, friction: float) -> tuple[Outcome, float, float]:
    """Outcome, lift and drag after a slide in steps of some radii."""
    rods = crossing(60.0, friction=friction)
    watch = Watch(rods)
    done = press(rods, watch, max(1, round(2.0 / step)))
    done and slide(rods, watch, SLIDE, max(1, round(SLIDE / step)))
    return watch.outcome(step, friction), lift(rods), drag(rods)


def outcome(step: float, friction: float) -> Outcome:
    """With the lift over that of the smallest steps."""
    found, up, _ = slid(step, friction)
    _, reference, _ = slid(STEPS[0], friction)
    return Outcome(
        **{**vars(found), "values": {"lift over that of small increments": up / reference}}
    )


STEPS = (0.06, 0.12, 0.3, 0.6, 1.2, 3.0, 6.0)
FAMILY = Family(
    "large_increments",
    "Large increments",
    ("motion per increment over the radius", "coefficient of friction"),
    (STEPS, (0.0, 0.1, 0.3, 0.6, 1.0)),
    outcome,
    "Beams that cross at 60 degrees are pressed on each other by two radii and slid by six; all in increments of a "
    "hundredth to all of the slide.",
    logarithmic=(True, False),
    means=(
        "Forces differ by less than 0.1 % whatever the increments, also with friction. Increments that would "
        "squeeze an element by more than a fifth are cut, since a beam that Newton has folded stays folded: "
        "before, steps of 3 radii ended there, with 2.8 times the force and without a word."
    ),
)
