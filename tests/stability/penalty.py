"""(c) Pressed and slid with penalties over six decades."""

from __future__ import annotations

from dataclasses import replace

from family import Family
from judge import Outcome, Watch
from scenes import SLIDE, crossing, press, slide

MODULUS = 1000.0  # MPa


def outcome(factor: float, limit: float) -> Outcome:
    """Penalty over the modulus; the limit of the penetration over the radius, 0: the penalty stays."""
    rods = crossing(
        60.0,
        modulus=MODULUS,
        friction=0.3,
        penalty=factor * MODULUS,
        penetration=limit or None,
    )
    watch = Watch(rods)
    press(rods, watch) and slide(rods, watch, SLIDE, 12)
    found = watch.outcome(factor, limit, penetration=watch.penetration)
    return replace(found, case=(factor, limit))


FAMILY = Family(
    "penalty",
    "Penalty",
    ("penalty over the modulus", "limit of penetration over the radius (0: none)"),
    ((1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3), (0.0, 0.001, 0.01, 0.1)),
    outcome,
    "Beams that cross at 60 degrees are pressed on each other by two radii and slid by six with a friction of 0.3. "
    "Penalties are per length of contact; with a limit they grow until penetrations are below it.",
    logarithmic=(True, False),
    means=(
        "Leave the penalty alone, or choose it within a tenth and ten times the modulus of the softest beam: "
        "stiffer ones cost iterations, softer ones penetrate (without a limit), and friction, which acts on "
        "both surfaces, then leaves a moment of the penetration times its force."
    ),
)
