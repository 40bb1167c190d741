"""The figure of the study of sensitivity: one tornado chart."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from pulled_values import LOADED, STIFFNESS
from sensitivity_bars import Bar, bars, widest_first
from study_runs import Outcome

from braidx.output.figures.style import AMBER, BLUE, INK, figure, panels, save, styled

PANELS = {
    STIFFNESS: "Axial stiffness EA and efficiency $C_{eff}$",
    LOADED: "Outer diameter under load",
}


def draw(outcomes: Sequence[Outcome], folder: Path) -> None:
    """study_sensitivity.png."""
    _draw(outcomes, folder / "study_sensitivity.png")


@styled
def _draw(outcomes: Sequence[Outcome], path: Path) -> Path:
    """Stiffness and efficiency are one panel: the yarns' stiffness, which they differ by, is the same in all cases."""
    order = [bar.parameter for bar in widest_first(bars(outcomes, STIFFNESS))]
    page = figure(10.0, 1.8 + 0.55 * len(order))
    for ax, (column, title) in zip(panels(page, 1, len(PANELS), sharey=True), PANELS.items()):
        found = {bar.parameter: bar for bar in bars(outcomes, column)}
        _tornado(ax, [found[parameter] for parameter in order])
        ax.set(title=title, xlabel="change (%)")
    return save(page, path)


def _tornado(ax: Axes, found: Sequence[Bar]) -> None:
    for row, bar in enumerate(found):
        for value, change in bar.changes.items():
            ax.barh(row, change, height=0.6, color=BLUE if change > 0.0 else AMBER)
            away = (4, 0) if change >= 0.0 else (-4, 0)
            side = "left" if change >= 0.0 else "right"
            told = f"{value}: {change:+.1f} %"
            ax.annotate(
                told,
                (change, row),
                away,
                textcoords="offset points",
                ha=side,
                va="center",
                fontsize=8,
            )
    ax.axvline(0.0, color=INK, lw=1.0)
    ax.set_yticks(np.arange(len(found)), [bar.parameter for bar in found])
    ax.set_ylim(len(found) - 0.4, -0.6)
    reach = max(abs(c) for bar in found for c in bar.changes.values()) or 1.0
    ax.set_xlim(-1.9 * reach, 1.9 * reach)
    ax.grid(True, axis="x")
    ax.set_axisbelow(True)
