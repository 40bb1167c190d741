"""Maps of families: a symbol per scene, its place given by the parameters."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from family import Family  # noqa: E402
from judge import CONVERGED, FAILED, REFUSED, SLOW, WRONG, Outcome  # noqa: E402

# Colours that those who do not tell red from green tell apart, and symbols for those who print in grey.
LOOKS = {
    CONVERGED: ("#0072b2", "o", "converged"),
    SLOW: ("#e69f00", "s", "slow"),
    FAILED: ("#999999", "X", "failed cleanly"),
    WRONG: ("#d40000", "*", "wrong"),
    REFUSED: ("#009e73", "v", "refused"),
}


def draw(family: Family, outcomes: Sequence[Outcome], path: Path) -> None:
    """Writes the map of a family, with the number of iterations at each symbol."""
    second = len(family.axes) > 1
    rows = len({outcome.case[1] for outcome in outcomes}) if second else 1
    figure, axes = plt.subplots(figsize=(7.6, 1.9 + 0.5 * rows), dpi=110, layout="constrained")
    _set_scales(axes, family)
    for status, (colour, marker, label) in LOOKS.items():
        chosen = [outcome for outcome in outcomes if outcome.status == status]
        if status == REFUSED and not chosen:
            continue
        x = [outcome.case[0] for outcome in chosen]
        y = [outcome.case[1] if second else 0.0 for outcome in chosen]
        axes.scatter(
            x, y, s=110, c=colour, marker=marker, label=f"{label} ({len(chosen)})", zorder=3
        )
    for outcome in outcomes:
        place = (outcome.case[0], outcome.case[1] if second else 0.0)
        axes.annotate(
            str(outcome.iterations),
            place,
            (0, 7),
            textcoords="offset points",
            ha="center",
            fontsize=7,
        )
    axes.margins(0.06, 0.25 if rows < 3 else 0.12)
    figure.legend(loc="outside upper center", ncols=4, frameon=False, fontsize=9)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    plt.close(figure)


def _set_scales(axes: plt.Axes, family: Family) -> None:
    axes.set_xlabel(family.axes[0])
    axes.set_xscale("log" if family.logarithmic[0] else "linear")
    _set_ticks(axes.xaxis, family.values[0])
    if len(family.axes) > 1:
        axes.set_ylabel(family.axes[1])
        axes.set_yscale("log" if family.logarithmic[1] else "linear")
        _set_ticks(axes.yaxis, family.values[1])
        if family.labels:
            axes.set_yticks(list(family.values[1]), family.labels)
    else:
        axes.set_yticks([])
    axes.grid(alpha=0.3)


def _set_ticks(axis: matplotlib.axis.Axis, values: Sequence[float]) -> None:
    axis.set_major_locator(matplotlib.ticker.FixedLocator(list(values)))
    axis.set_minor_locator(matplotlib.ticker.NullLocator())
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:g}"))
