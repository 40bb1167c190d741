"""(c) Pressed and slid with penalties over six decades."""

from __future__ import annotations

from dataclasses import replace

from family import Family
from judge import Outcome, Watch
from scenes import SLIDE, crossing, press, slide

MODULUS = 1000.0  # MPa
NO_LIMIT = 1.0


def outcome(factor: float, limit: float) -> Outcome:
    """Penalty over the modulus; the limit of the penetration over the radius, NO_LIMIT: the penalty stays."""
    rods = crossing(
        60.0,
        modulus=MODULUS,
        friction=0.3,
        penalty=factor * MODULUS,
        penetration=limit if limit < NO_LIMIT else None,
    )
    watch = Watch(rods)
    press(rods, watch) and slide(rods, watch, SLIDE, 12)
    found = watch.outcome(factor, limit, penetration=watch.penetration)
    return replace(found, case=(factor, limit))


FAMILY = Family(
    "penalty",
    "Penalty",
    ("penalty over the modulus", "limit of penetration over the radius"),
    ((1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3), (0.001, 0.01, 0.1, NO_LIMIT)),
    outcome,
    "Beams that cross at 60 degrees are pressed on each other by two radii and slid by six with a friction of 0.3. "
    "Penalties are per length of contact; with a limit they grow until penetrations are below it.",
    logarithmic=(True, True),
    labels=("0.001", "0.01", "0.1", "none"),
    means=(
        "Leave the penalty alone: from 0.001 to 1 times the modulus iterations are much the same, 10 times "
        "takes twice, 1000 times three times as many. Without a limit, soft penalties penetrate (0.17 radii "
        "at 0.001), and friction, which acts on both surfaces, leaves a moment of its force times the "
        "penetration."
    ),
)
