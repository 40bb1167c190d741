"""(a) Two beams pressed on each other at a crossing angle, against the length of their elements."""

from __future__ import annotations

from family import Family
from judge import Outcome, Watch
from scenes import crossing, press


def outcome(angle: float, length: float) -> Outcome:
    """The ends of the upper beam go down by two radii in four increments."""
    rods = crossing(angle, (length, length))
    watch = Watch(rods)
    press(rods, watch)
    return watch.outcome(angle, length)


FAMILY = Family(
    "crossing_angle",
    "Crossing angle",
    ("crossing angle, degrees", "length of elements over the radius"),
    ((0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 45.0, 90.0), (2.0, 4.0, 8.0, 16.0)),
    outcome,
    "Two beams touch at an angle; the clamped ends of the upper one go down by two radii. At small angles beams are "
    "as long as it takes for their ends to be clear of each other: held ends that are told to be within each other "
    "have no equilibrium, and are refused.",
    means=(
        "Any angle down to half a degree does; from 10 degrees on it costs nothing extra. At 5 degrees it "
        "takes two to three times the iterations, below 7 to 20 times. Stations are two radii apart at most, "
        "whatever the elements: with half an element, the default before, elements of 16 radii at 10 degrees "
        "overlapped by 6 % of a diameter without a word."
    ),
)
