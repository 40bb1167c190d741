"""(d) How many elements slender beams take."""

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
        "Eight elements will do, whatever the slenderness. When sections contracted by the axial strain at the nodes "
        "(theory) it took elements of 6 radii at a slenderness of 100, 31 at 1000 and 78 at 1e4, and nothing told."
    ),
)
