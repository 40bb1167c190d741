"""Paper 1, figures 17 and 18: pitches of 121, 131, 132 and 153 mm, and the stiffness over cos^2 of the helix angle.

./braidx shell python3 tests/studies/pitch_length.py
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from pitch_angles import angles
from pitch_figure import draw
from pulled_values import EFFICIENCY, FORMED, LOADED, SCATTER, STIFFNESS, curve_of
from study import DOCS, SMALL, SMALL_PROGRAMME, TENSILE, Case, Study, main
from study_page import Claim, Page, column, listed, table
from study_runs import Outcome

PITCHES = (121, 131, 132, 153)
ALIKE = 0.01  # by which tests of one real rope differ (table 2)
LINEAR = 0.95  # least R^2 of what is called a straight line
IN_PROPORTION = (0.8, 1.2)  # exponent of cos^2 that is called one
PITCH = 132.0  # mm, of the real rope
MEASURED, MODEL = 9512.0, 9880.0  # kN, paper 1: table 2, and 5.2.1


def study(quick: bool = False) -> Study:
    pitches = (36, 40) if quick else PITCHES
    return Study(
        name="pitch_length",
        title="Pitch of the rope",
        quantity="pitch (mm)",
        cases=tuple(Case(f"{pitch}", float(pitch), (f"rope.pitch={pitch}",)) for pitch in pitches),
        base=SMALL if quick else (),
        demo=TENSILE,
        programme=SMALL_PROGRAMME if quick else (),
    )


def claims(outcomes: Sequence[Outcome]) -> list[Claim]:
    """What the paper says of the pitch."""
    found, stiffness = angles(outcomes), column(outcomes, STIFFNESS)
    low, high = IN_PROPORTION
    at = int(np.argmin([abs(outcome.case.value - PITCH) for outcome in outcomes]))
    off = stiffness[at] / MEASURED - 1.0
    return [
        Claim(
            "rises",
            "the axial stiffness rises with the pitch (figure 18)",
            "it does from the first to the last, and falls by no more than tests of one rope differ by, "
            f"{100 * ALIKE:.0f} %, from one to the next",
            listed(stiffness, ".0f") + " kN",
            bool(stiffness[-1] > stiffness[0] and (np.diff(np.log(stiffness)) > -ALIKE).all()),
        ),
        Claim(
            "linear",
            "it evolves linearly with $\\cos^2\\alpha$ (5.2.3, figure 18)",
            f"$R^2$ of a straight line through the four is at least {LINEAR}",
            f"$R^2$ = {found.line.r_squared:.3f}",
            found.line.r_squared >= LINEAR,
        ),
        Claim(
            "in proportion",
            "because strain and force of a yarn each go with $\\cos\\alpha$ (5.2.3), that is, in proportion to it",
            f"the exponent of $\\cos^2\\alpha$ is {low} to {high}",
            f"exponent {found.exponent:.1f}",
            low <= found.exponent <= high,
        ),
        Claim(
            "as measured",
            f"at 132 mm {MEASURED:.0f} kN (experiment) and {MODEL:.0f} kN (model)",
            "within 10 % of the experiment",
            f"{stiffness[at]:.0f} kN, {100 * off:+.1f} %",
            abs(off) <= 0.1,
        ),
    ]


def numbers(outcomes: Sequence[Outcome]) -> dict[str, str | float]:
    """Of the page."""
    found = angles(outcomes)
    rows = [
        [
            outcome.case.label,
            f"{radius:.2f}",
            f"{math.degrees(angle):.2f}",
            f"{square:.4f}",
            f"{yarns:.3f}",
            *[f"{outcome.values[STIFFNESS]:.0f}", f"{outcome.values[EFFICIENCY]:.3f}"],
            *[f"{outcome.values[name]:.2f}" for name in (FORMED, LOADED)],
            f"{outcome.values[SCATTER]:.0f}",
            "{:.0f} to {:.0f}".format(*slopes(outcome)),
        ]
        for outcome, radius, angle, square, yarns in zip(
            outcomes, found.radius, found.angle, found.square, found.yarns, strict=True
        )
    ]
    header = [
        "pitch (mm)",
        "radius of the strands' helices (mm)",
        "$\\alpha$ (degrees)",
        "$\\cos^2\\alpha$",
        "efficiency by the yarns' directions alone",
        "axial stiffness (kN)",
        "efficiency",
        "diameter, formed (mm)",
        "at 70 kN (mm)",
        "deviation of stress at 70 kN (MPa)",
        "slopes above half of the force (kN)",
    ]
    shares = [e / alone for e, alone in zip(column(outcomes, EFFICIENCY), found.yarns)]
    return {
        "table": table(header, rows),
        "slope": found.line.slope,
        "constant": found.line.constant,
        "r_squared": found.line.r_squared,
        "exponent": found.exponent,
        "stiffness_change": rise(column(outcomes, STIFFNESS)),
        "square_change": rise(found.square),
        "yarn_change": rise(found.yarns),
        "shares": listed(shares, ".2f"),
    }


def slopes(outcome: Outcome) -> tuple[float, float]:
    """Least and largest slope from one increment to the next, of those above half of the force, kN."""
    curve = curve_of(outcome.folder)
    upper = curve.force[:-1] >= 0.5 * curve.force.max()
    found = (np.diff(curve.force) / np.diff(curve.strain))[upper]
    return float(found.min()), float(found.max())


def rise(values: Sequence[float]) -> float:
    """From the least to the largest, %."""
    return 100.0 * (max(values) / min(values) - 1.0)


PAGE = Page("pitch", claims, numbers, draw)

if __name__ == "__main__":
    raise SystemExit(main(study, report=PAGE.report(), docs=DOCS))
