"""Paper 1, figure 12b: five bedding-in cycles, and the pull after them.

./braidx shell python3 tests/studies/bedding_in.py
"""

from __future__ import annotations

from collections.abc import Sequence

from bedding_figure import draw
from load_cycles import LoadCycle, load_cycles
from pulled_values import STIFFNESS, curve_of
from study import DOCS, SMALL, TENSILE, Case, Study, main
from study_page import Claim, Page, listed, table
from study_runs import Outcome

from braidx.scene import Cycle, Pull, Settle, load_scene

CYCLES, HIGH, LOW = 5, 70.0, 1.0  # kN
STEADY = 0.05  # share by which a cycle may exceed the one before and still not be called a rise


def study(quick: bool = False) -> Study:
    high = 4.0 if quick else HIGH
    cycles = Cycle(force_max=high, force_min=LOW, cycles=2 if quick else CYCLES)
    return Study(
        name="bedding_in",
        title="Bedding-in cycles",
        quantity="friction (-)",
        cases=(Case("0.1", 0.1),),
        base=SMALL if quick else (),
        demo=TENSILE,
        programme=(Settle(force=LOW), cycles, Pull(to_force=high * 10.0 / 7.0)),
    )


def cycles_of(outcome: Outcome) -> list[LoadCycle]:
    return load_cycles(curve_of(outcome.folder))


def claims(outcomes: Sequence[Outcome]) -> list[Claim]:
    """What the paper says of its real rope."""
    found = cycles_of(outcomes[0])
    area = [cycle.hysteresis for cycle in found]
    residual = [cycle.residual_strain for cycle in found]
    first, last = found[0].linearity, found[-1].linearity
    rises = max(after / before - 1.0 for before, after in zip(area, area[1:]))
    return [
        Claim(
            "less hysteresis",
            "hysteresis tends to decrease with the number of cycles (figure 12b)",
            f"the last cycle has less than the first, and none {100 * STEADY:.0f} % more than the one before",
            listed(area, ".1f") + " J/m",
            area[-1] < area[0] and rises <= STEADY,
        ),
        Claim(
            "first cycle",
            "most of the residual strain is removed during the first cycle",
            "the first cycle leaves more than half of what all leave",
            f"{100 * residual[0]:.3f} % of {100 * residual[-1]:.3f} %",
            residual[0] > 0.5 * residual[-1] > 0.0,
        ),
        Claim(
            "more linear",
            "the form of the curve then becomes more linear",
            "$R^2$ of a straight line through the loading branch is larger in the last cycle than in the first",
            f"$R^2$ = {last:.5f} after {first:.5f}",
            last > first,
        ),
    ]


def numbers(outcomes: Sequence[Outcome]) -> dict[str, str | float]:
    """Of the page."""
    outcome, found = outcomes[0], cycles_of(outcomes[0])
    length = load_scene(outcome.folder / "scene.toml").length
    rows = [
        [
            f"{number}",
            f"{cycle.hysteresis:.1f}",
            f"{100 * cycle.hysteresis / cycle.pulled:.1f}",
            f"{cycle.friction_work / length:.1f}",
            f"{100 * cycle.residual_strain:.4f}",
            f"{cycle.stiffness:.0f}",
            f"{cycle.linearity:.5f}",
        ]
        for number, cycle in enumerate(found, 1)
    ]
    header = [
        "cycle",
        "hysteresis (J/m)",
        "of the work of pulling (%)",
        "friction work (J/m)",
        "residual strain (%)",
        "slope of the upper half (kN)",
        "$R^2$ of the loading branch",
    ]
    later = found[1:]
    residual = [100.0 * cycle.residual_strain for cycle in found]
    return {
        "table": table(header, rows),
        "added": listed([after - before for before, after in zip(residual, residual[1:])], ".3f"),
        "first": residual[0],
        "stiffness": outcome.values[STIFFNESS],
        "balance": 100.0
        * sum(c.friction_work for c in later)
        / length
        / sum(c.hysteresis for c in later),
    }


PAGE = Page("bedding_in", claims, numbers, draw)

if __name__ == "__main__":
    raise SystemExit(main(study, report=PAGE.report(), docs=DOCS))
