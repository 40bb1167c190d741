"""Study A of paper 2: the rope over sheaves of D/d 3.33 to 10.

./braidx shell python3 tests/studies/diameter_ratio.py
"""

import math

from scipy.optimize import brentq
from study import QUICK, Case, Statement, Study, main

ROPE = 12.0  # mm, the paper's diameter
HALF = 87.1  # mm, half of the demo's sample
TRAVEL = 60.0  # mm, of the ends over the smallest sheave
STATEMENTS = (
    Statement("paper 2: slightly over 0.7 mm below D/d = 4", 0.7, (3.0, 4.0)),
    Statement("paper 2: falls as D/d rises"),
)


def travel_at(turn: float, diameter: float) -> float:
    """Travel (mm) of ends that have turned by an angle: the rope lies on the sheave and is straight beyond."""
    radius = (diameter + ROPE) / 2.0
    return radius * (1.0 - math.cos(turn)) + (HALF - radius * turn) * math.sin(turn)


def study(quick: bool = False) -> Study:
    diameters, rope = ((20, 40), 5.6) if quick else ((40, 60, 80, 120), ROPE)
    turn = brentq(lambda angle: travel_at(angle, diameters[0]) - TRAVEL, 0.0, 1.2)
    cases = [
        Case(
            f"{diameter / rope:.2f}",
            diameter / rope,
            (
                f"sheave.diameter={diameter}",
                *([] if quick else [f"steps.bend.travel={travel_at(turn, diameter):.1f}"]),
            ),
        )
        for diameter in diameters
    ]
    return Study(
        name="diameter_ratio",
        title="A: diameter of the sheave over that of the rope",
        quantity="D/d (-)",
        cases=tuple(cases),
        statements=STATEMENTS,
        base=QUICK if quick else (),
        chosen=(
            "The paper moves the ends by 60 mm over every sheave; how long its sample is it does not say. The demo's "
            "174 mm would be drawn taut over the largest sheave before its ends have come so far, and a longer sample "
            "lies on the smallest sheave over less than a pitch. Chosen: over every sheave the ends turn by the same "
            f"angle as over the smallest, {math.degrees(turn):.0f} degrees, so that only the curvature varies."
        ),
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
