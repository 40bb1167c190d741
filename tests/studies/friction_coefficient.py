"""Paper 1, figures 19 and 20: one rope pulled with friction 0.003, 0.03 and 0.1.

./braidx shell python3 tests/studies/friction_coefficient.py
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from friction_figure import draw
from pulled_values import FORMED, LOADED, STIFFNESS, Curve, curve_of, loaded_state, straight_line
from stress_spread import Spread, spread
from study import DOCS, SMALL, SMALL_PROGRAMME, TENSILE, Case, Study, main
from study_page import Claim, Page, column, listed, table
from study_runs import Outcome

from braidx.output.measures import linear_fit

FRICTIONS = (0.003, 0.03, 0.1)
AT_REST = 2.0  # kN
TAUT = 20.0  # kN
SAME = 0.05  # largest difference of stiffnesses that are called equal, over their mean


def study(quick: bool = False) -> Study:
    return Study(
        name="friction_coefficient",
        title="Friction between yarns",
        quantity="friction (-)",
        cases=tuple(Case(f"{mu:g}", mu, (f"contact.friction={mu:g}",)) for mu in FRICTIONS),
        base=(
            (*SMALL, "steps.form.friction=0.1")
            if quick
            else (f"steps.settle.force={AT_REST}", "steps.settle.increments=100")
        ),
        demo=TENSILE,
        programme=SMALL_PROGRAMME if quick else (),
    )


def toe(outcome: Outcome) -> float:
    """Strain from the formed rope at which the line through the linear part of the curve has no force, -."""
    curve = curve_of(outcome.folder)
    return linear_fit(curve.strain, curve.force).offset


def held_later(curve: Curve) -> float:
    """Largest work of the stabilisation over the elastic energy once the rope is taut, -."""
    return float(curve.held[curve.force >= TAUT].max(initial=0.0))


def taut_slope(outcome: Outcome) -> float:
    """Slope of the last pull, from the state that it starts from, kN."""
    curve = curve_of(outcome.folder)
    first = int(np.flatnonzero(curve.step == curve.step[-1])[0]) - 1
    return straight_line(curve.strain[first:], curve.force[first:]).slope


def spreads(outcomes: Sequence[Outcome]) -> list[Spread]:
    """Of the axial stress at the end of the first pull."""
    return [spread(loaded_state(outcome.folder)) for outcome in outcomes]


def claims(outcomes: Sequence[Outcome]) -> list[Claim]:
    """What the paper says of friction."""
    stiffness, found = column(outcomes, STIFFNESS), spreads(outcomes)
    toes = [100.0 * toe(outcome) for outcome in outcomes]
    difference = float(np.ptp(stiffness) / np.mean(stiffness))
    whole = [100.0 * s.deviation / s.mean for s in found]
    along = [100.0 * s.along / s.mean for s in found]
    return [
        Claim(
            "same stiffness",
            "the rope's stiffness no longer depends on friction once the gaps have vanished (figure 19)",
            f"stiffnesses differ by no more than {100 * SAME:.0f} %",
            f"{listed(stiffness, '.0f')} kN, {100 * difference:.1f} %",
            difference <= SAME,
        ),
        Claim(
            "shorter toe",
            "friction influences the beginning of the curve: more of it, less rearrangement to fill voids (figure 19)",
            "the strain that the linear part starts from falls with each step of friction",
            f"{listed(toes, '.3f')} % of strain",
            bool((np.diff(toes) < 0.0).all()),
        ),
        Claim(
            "more scatter",
            "a much larger variability in loads with higher friction (figure 20)",
            "the deviation of stress over its mean rises with each step of friction",
            f"{listed(whole, '.1f')} %",
            bool((np.diff(whole) > 0.0).all()),
        ),
        Claim(
            "more along yarns",
            "explained by non-uniform load transfers between yarns, resulting in local stress concentrations",
            "the deviation along yarns, over the mean stress, rises with each step of friction",
            f"{listed(along, '.1f')} %",
            bool((np.diff(along) > 0.0).all()),
        ),
    ]


def numbers(outcomes: Sequence[Outcome]) -> dict[str, str | float]:
    """Of the page."""
    rows = []
    for outcome, found in zip(outcomes, spreads(outcomes), strict=True):
        curve = curve_of(outcome.folder)
        rows.append(
            [
                outcome.case.label,
                f"{100 * curve.strain[0]:.3f}",
                f"{100 * toe(outcome):.3f}",
                f"{outcome.values[STIFFNESS]:.0f}",
                f"{taut_slope(outcome):.0f}",
                *[f"{outcome.values[name]:.2f}" for name in (FORMED, LOADED)],
                f"{found.mean:.0f}",
                *[f"{value:.0f}" for value in (found.deviation, found.among, found.along)],
                f"{found.highest:.2f}",
                f"{100 * curve.held[0]:.1f}",
                f"{100 * held_later(curve):.2f}",
            ]
        )
    header = [
        "friction",
        f"strain at rest, {AT_REST:.0f} kN (%)",
        "strain that the linear part starts from (%)",
        "axial stiffness (kN)",
        "slope from 70 kN on (kN)",
        "diameter, formed (mm)",
        "at 70 kN (mm)",
        "mean stress at 70 kN (MPa)",
        "deviation (MPa)",
        "among yarns (MPa)",
        "along yarns (MPa)",
        "highest over mean",
        "held at rest (%)",
        "held from 20 kN on (%)",
    ]
    return {"table": table(header, rows), "at_rest": AT_REST}


PAGE = Page("friction", claims, numbers, draw)

if __name__ == "__main__":
    raise SystemExit(main(study, report=PAGE.report(), docs=DOCS))
