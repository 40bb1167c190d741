"""What paper 1 does not state, and what it matters: stiffness, efficiency and diameter, one choice changed at a time.

./braidx shell python3 tests/studies/sensitivity.py
"""

from __future__ import annotations

from collections.abc import Sequence

from pulled_values import EFFICIENCY, FORMED, LOADED, STIFFNESS
from sensitivity_bars import BASE, bars, widest_first
from sensitivity_figure import draw
from study import DOCS, SMALL, TENSILE, Case, Study, main
from study_page import Claim, Page, column, table
from study_runs import Outcome
from summaries import SECONDS

from braidx.scene import Pull, Settle

LOAD = 30.0  # kN
CASES = {  # by label, "PARAMETER: VALUE"
    BASE: (),
    "yarn pitch (132 mm): 66 mm": ("strand.yarn_pitch=pitch/2",),
    "yarn radius (0.81 mm): 0.86 mm": (
        "yarn.radius=0.86",
        "strand.helix_radius=1.72",
        "braid.helix_radius=6.0",
        "steps.form.die_diameter=20.5",
    ),
    "Poisson ratio (0.3): 0": ("yarn.poisson_axial=0",),
    "Poisson ratio (0.3): 0.45": ("yarn.poisson_axial=0.45",),
    "transverse modulus (78.6 GPa): 5 GPa": ("yarn.transverse_modulus=5e3",),
    "bundle factor (1e-4): 1e-2": ("yarn.bundle_factor=1e-2",),
}
QUICK = {label: CASES[label] for label in (BASE, "Poisson ratio (0.3): 0")}


def study(quick: bool = False) -> Study:
    cases = QUICK if quick else CASES
    load = 5.0 if quick else LOAD
    return Study(
        name="sensitivity",
        title="What the paper leaves open",
        quantity="choice",
        cases=tuple(Case(label, float(i), words) for i, (label, words) in enumerate(cases.items())),
        base=(*(SMALL if quick else ()), "yarn.model=beam"),
        named=True,
        demo=TENSILE,
        programme=(Settle(force=0.1 * load if quick else 7.0), Pull(to_force=load)),
    )


def claims(outcomes: Sequence[Outcome]) -> list[Claim]:
    """What the paper measured, and whether its open choices reach it."""
    said = (
        ("efficiency", EFFICIENCY, 0.699, "0.699 of the real rope (4.4)", ".3f", ""),
        ("diameter", LOADED, 19.0, "19.0 mm of the real rope in tension (table 3)", ".2f", " mm"),
    )
    found = []
    for name, quantity, reference, source, form, unit in said:
        values = column(outcomes, quantity)
        low, high = (format(end, form) for end in (min(values), max(values)))
        found.append(
            Claim(
                name,
                f"{name}: {source}",
                "some choice lies below, and some above",
                f"{low} to {high}{unit}",
                min(values) <= reference <= max(values),
            )
        )
    bundle = [bar for bar in bars(outcomes, STIFFNESS) if bar.parameter.startswith("bundle")]
    if bundle:
        found.append(
            Claim(
                "bundle factor",
                "bending and torsion of yarns are much lower than of a solid (5.1); the factor, the inverse of the "
                "number of filaments, is given approximately",
                "a factor 100 times as large changes the stiffness by less than 5 %",
                f"{bundle[0].changes['1e-2']:+.1f} %",
                bundle[0].span < 5.0,
            )
        )
    return found


def numbers(outcomes: Sequence[Outcome]) -> dict[str, str | float]:
    """Of the page."""
    rows = [
        [
            outcome.case.label,
            f"{outcome.values[STIFFNESS]:.0f}",
            f"{outcome.values[EFFICIENCY]:.3f}",
            *[f"{outcome.values[name]:.2f}" for name in (FORMED, LOADED)],
            f"{outcome.values[SECONDS]:.0f}",
        ]
        for outcome in outcomes
    ]
    header = [
        "choice (in brackets the demo's)",
        "axial stiffness (kN)",
        "efficiency $C_{eff}$",
        "diameter, formed (mm)",
        f"at {LOAD:g} kN (mm)",
        "seconds",
    ]
    order = widest_first(bars(outcomes, STIFFNESS))
    spans = "; ".join(
        f"{bar.parameter} {' and '.join(f'{value:+.1f}' for value in bar.changes.values())} %"
        for bar in order
    )
    return {"table": table(header, rows), "spans": spans, "load": LOAD}


PAGE = Page("sensitivity", claims, numbers, draw)

if __name__ == "__main__":
    raise SystemExit(main(study, report=PAGE.report(), docs=DOCS))
