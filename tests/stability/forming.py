"""(m) Yarns that start in each other: how fast they are taken apart, and how hard they are pressed on each other."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from family import Family
from judge import CONVERGED, WRONG, Outcome
from rope_recipes import small_braid
from ropes import outcome as rope_outcome

STEPS = (0.05, 0.2, 0.5, 1.0, 5.0)  # yarn radii
PENALTIES = (3e-3, 0.03, 0.3, 3.0, 30.0, 300.0, 3e3, 3e4)  # tension / radius^2
USUAL = (0.5, 3.0)
PULL = {"kind": "pull", "to_force": 1.0}
SAME = 0.01  # of the diameter of the rope when it is pulled


@cache
def pulled(step: float, penalty: float) -> Outcome:
    """A braid is taken apart in steps of some radii with a penalty, brought to rest, and pulled to 1 kN."""
    recipe = small_braid("cable", 1.0, PULL, gap_reduction=step, penalty=penalty)
    return rope_outcome((step, penalty), recipe)


def formed(step: float, penalty: float) -> Outcome:
    """Compared with the rope of the default step and penalty: the way to the shape is not to show in it."""
    found, usual = pulled(step, penalty), pulled(*USUAL)
    error = found.values["diameter"] / usual.values["diameter"] - 1.0
    found = replace(found, values={**found.values, "error": error})
    if found.status == CONVERGED and abs(error) > SAME:
        return replace(found, status=WRONG, why=f"another diameter: {error:+.1%}")
    return found


FAMILY = Family(
    "forming",
    "Yarns that start in each other",
    ("gap reduction per increment (yarn radii)", "penalty (tension / radius²)"),
    (STEPS, PENALTIES),
    formed,
    "The rope of `demos/small_rope.toml` with 24 elements, whose strands start on one helix, as deep in each other as "
    "can be: taken apart by `form.gap_reduction` and `form.penalty`, brought to rest, and pulled to 1 kN. Its "
    "diameter has to be that of the rope with the defaults (0.5 and 3), within 1 %.",
    means=(
        "Leave both alone: however fast yarns are taken apart, and with penalties from a thousandth to a thousand "
        "times the default, the rope is the same, its diameter within 0.8 %. Small steps cost increments (0.05 radii: "
        "three times the default's iterations), soft penalties do too, since yarns give way to them and the penalty "
        "has to be raised; of stiff ones, 30 takes a few iterations less than the default, and from 3000 on many "
        "more. Ten thousand times the default takes 9 to 30 times as many, and taken apart fastest the rope is not "
        "formed, and says so."
    ),
)
