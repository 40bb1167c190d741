"""The figure of the study of friction."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from pulled_values import Array, Curve, curve_of, loaded_state
from stress_spread import spread
from study_runs import Outcome

from braidx.output import Snapshot
from braidx.output.figures.style import AMBER, BLUE, INK, figure, save, styled

COLOURS = (AMBER, INK, BLUE)
TOE = 12.0  # kN, of the beginning of the curve
BINS, FEW = 41, 17  # edges of bins: of segments, and of yarns, which come in threes


def draw(outcomes: Sequence[Outcome], folder: Path) -> None:
    """study_friction.png: curves, their beginning, and distributions of stress (figures 19 and 20 of paper 1)."""
    _draw(outcomes, folder / "study_friction.png")


@styled
def _draw(outcomes: Sequence[Outcome], path: Path) -> Path:
    page = figure(10.0, 7.2)
    grid = page.add_gridspec(2, 6)
    whole, beginning = page.add_subplot(grid[0, :3]), page.add_subplot(grid[0, 3:])
    for ax in (whole, beginning):
        _curves(outcomes, ax)
    whole.set_title("Force and strain (figure 19)")
    whole.legend(loc="upper left")
    strains = [np.interp(TOE, curve.force, curve.strain) for curve in map(_curve, outcomes)]
    least = min(float(_curve(outcome).strain[0]) for outcome in outcomes)
    beginning.set(xlim=(100 * least - 0.02, 100 * max(strains)), ylim=(0.0, TOE))
    beginning.set_title("Their beginning")
    states = [loaded_state(outcome.folder) for outcome in outcomes]
    _histograms(outcomes, states, [page.add_subplot(grid[1, 2 * k : 2 * k + 2]) for k in range(3)])
    return save(page, path)


def _curve(outcome: Outcome) -> Curve:
    return curve_of(outcome.folder)


def _curves(outcomes: Sequence[Outcome], ax: Axes) -> None:
    for outcome, colour in zip(outcomes, COLOURS):
        curve = _curve(outcome)
        label = f"friction {outcome.case.label}"
        ax.plot(100.0 * curve.strain, curve.force, "o-", color=colour, ms=2.5, lw=1.4, label=label)
    ax.set(xlabel="strain from the formed rope (%)", ylabel="force (kN)")
    ax.set_ylim(bottom=0.0)
    ax.grid(True)


def _histograms(
    outcomes: Sequence[Outcome], states: Sequence[Snapshot], axes: Sequence[Axes]
) -> None:
    """Stress of all segments, means of yarns, and departures from them."""
    found = [spread(state) for state in states]
    all_of_it = [(s.stress, s.length) for s in found]
    means = [(s.yarn_means, np.ones(len(s.yarn_means))) for s in found]
    along = [(s.stress - s.own_mean, s.length) for s in found]
    deviations = [[getattr(s, name) for s in found] for name in ("deviation", "among", "along")]
    titles = (
        f"Stress at {states[0].name} (figure 20)",
        "Means of yarns",
        "Along yarns, from their own mean",
    )
    shares = ("share of the yarns' length (%)", "share of the yarns (%)", "share of the length (%)")
    for ax, data, title, share, values in zip(
        axes, (all_of_it, means, along), titles, shares, deviations
    ):
        labels = [f"{o.case.label}: deviation {v:.0f} MPa" for o, v in zip(outcomes, values)]
        _histogram(ax, data, labels, FEW if data is means else BINS)
        ax.set(title=title, ylabel=share, xlabel="axial stress (MPa)")


def _histogram(
    ax: Axes, data: Sequence[tuple[Array, Array]], labels: Sequence[str], count: int
) -> None:
    everything = np.concatenate([values for values, _ in data])
    edges = histogram_edges(everything, count)
    for (values, weights), colour, label in zip(data, COLOURS, labels):
        share = 100.0 * weights / weights.sum()
        ax.hist(values, list(edges), weights=share, histtype="stepfilled", color=colour, alpha=0.12)
        ax.hist(
            values, list(edges), weights=share, histtype="step", color=colour, lw=1.3, label=label
        )
    ax.margins(y=0.35)
    ax.legend(loc="upper left", fontsize=7.5)


def histogram_edges(values: Array, count: int) -> Array:
    """Edges of equal bins that hold all values, shape (count,)."""
    spread = max(float(np.ptp(values)), 1e-6)
    return np.linspace(values.min() - 0.01 * spread, values.max() + 0.01 * spread, count)
