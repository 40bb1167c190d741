"""(d) The remedy for very slender beams: shorter elements."""

from __future__ import annotations

from family import Family
from judge import Outcome
from slenderness import bent


def outcome(slenderness: float, elements: float) -> Outcome:
    """The cantilever bent by a force in ten increments, with other numbers of elements."""
    return bent(slenderness, 10.0, int(elements), (slenderness, elements))


FAMILY = Family(
    "refinement",
    "Slenderness: more elements",
    ("length over radius", "elements"),
    ((1e2, 1e3, 1e4, 1e5), (8.0, 16.0, 32.0, 64.0, 128.0)),
    outcome,
    "The cantilever bent by a force, in ten increments, with more and fewer elements.",
    means=(
        "Errors of 0.2 % of the length need elements of 6 radii at slenderness 100, 31 at 1000, 78 at 1e4. "
        "What is wrong here is too coarse: look at the answer of twice as many elements before you trust one."
    ),
)
