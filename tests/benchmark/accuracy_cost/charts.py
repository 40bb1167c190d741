"""Charts of error against cost, one image per scene."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from bench import Bench, Outcome, Sweep, error, front, key

from matplotlib.ticker import LogLocator, NullFormatter

from braidx.output.figures.style import figure, panels, save, styled

COLOURS = ("#3f6fa8", "#d69a3c", "#4f9a6b", "#b4503f", "#7d5ba6", "#8a8f98", "#1f8a9e", "#c27ba0")
MARKERS = "os^vDPX<>p"
LOOKS = [(COLOURS[i % 8], MARKERS[i % 10]) for i in range(20)]
STAR, FRONT = "#d12a2a", "#9aa0a8"
EXACT = 1e-6  # errors below are drawn there
Axes = Any
COSTS = {
    "seconds": "CPU time (s), one thread",
    "unknowns": "unknowns of the largest system",
    "iterations": "Newton iterations",
}
ROWS = (  # what is varied, the costs it is drawn over
    ("models and meshes", True, ("seconds", "unknowns")),
    ("all else", False, ("seconds", "iterations")),
)
WORST, LEAST_SPAN = 3.0, 30.0  # error at the upper edge, at most; upper over lower edge, at least
MANY_DECADES = 500.0  # span of an axis beyond which powers of ten alone are labelled
ROOM = (0.12, 0.04)  # of a name, as a share of the panel
Named = tuple[float, float, str, str]


@styled
def draw(bench: Bench, outcomes: Mapping[str, Outcome], path: Path) -> Path:
    """Error against cost: models and meshes, then all else; the Pareto front of each, the default as a star."""
    rows = [row for row in ROWS if any(sweep.is_mesh == row[1] for sweep in bench.sweeps)]
    page = figure(10.0, 4.1 * len(rows))
    page.suptitle(bench.title, x=0.01, ha="left", fontsize=11)
    for part, (title, mesh, costs) in zip(
        page.subfigures(len(rows), 1, squeeze=False).ravel(), rows
    ):
        chosen = [sweep for sweep in bench.sweeps if sweep.is_mesh == mesh]
        sweeps = [(sweep, *look) for sweep, look in zip(chosen, LOOKS)]
        axes = panels(part, 1, 2, sharey=True)
        named = [_panel(each, bench, outcomes, cost, sweeps) for each, cost in zip(axes, costs)]
        axes[0].set(ylabel="error (%)", title=title)
        low, high = axes[0].get_ylim()
        high = min(high, 100.0 * WORST)
        axes[0].set_ylim(min(low, high / LEAST_SPAN), high)
        for each, names in zip(axes, named):
            _label(each)
            _name(each, names)
        handles, labels = axes[0].get_legend_handles_labels()
        part.legend(handles, labels, loc="outside right upper", fontsize=8)
    return save(page, path)


def _panel(
    axes: Axes,
    bench: Bench,
    outcomes: Mapping[str, Outcome],
    cost: str,
    sweeps: Sequence[tuple[Sweep, str, str]],
) -> list[Named]:
    """Draws sweeps over one kind of cost; returns the points that are named if there is room."""
    default = outcomes[key({})]
    star = getattr(default, cost), percent(error(bench, default, outcomes))
    _draw_front(axes, bench, outcomes, cost)
    named: list[Named] = []
    for sweep, colour, marker in sweeps:
        points = [
            (getattr(outcome, cost), percent(error(bench, outcome, outcomes)), label)
            for outcome, label in found(sweep, outcomes)
        ]
        points = [p for p in points if math.isfinite(p[1]) and p[0] > 0 and p[1] > 100 * EXACT]
        if points:
            line = "-" if sweep.joined else "none"
            x, y, _ = zip(*points)
            axes.plot(x, y, marker, ls=line, lw=1, ms=5, color=colour, label=sweep.title)
            ends = points if not sweep.joined else [points[0], points[-1]]
            named += [(*point, colour) for point in ends]
    axes.plot(*star, "*", ms=15, color=STAR, mec="white", zorder=5, label="default")
    axes.set(xscale="log", yscale="log", xlabel=COSTS[cost])
    axes.grid(True, which="both", alpha=0.5)
    return [(*star, "default", STAR), *named]


def _label(axes: Axes) -> None:
    """Ticks where they can be read: 1, 2, 5 and tens of them, or powers of ten."""
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        few = high / low > MANY_DECADES
        axis.set_major_locator(LogLocator(subs=(1.0,) if few else (1.0, 2.0, 5.0)))
        axis.set_major_formatter(lambda value, _: f"{value:g}")
        axis.set_minor_formatter(NullFormatter())


def _name(axes: Axes, named: Sequence[Named]) -> None:
    """Says which runs points are, but where another one that is named, or the default, is near."""
    taken: list[tuple[float, float]] = []
    for x, y, label, colour in named:
        across, up = axes.transAxes.inverted().transform(axes.transData.transform((x, y)))
        near = any(abs(across - a) < ROOM[0] and abs(up - b) < ROOM[1] for a, b in taken)
        if near or not 0.0 <= up <= 1.0:
            continue
        taken.append((across, up))
        if label != "default":
            place = {"xytext": (4, 3), "textcoords": "offset points"}
            axes.annotate(label, (x, y), fontsize=6.5, color=colour, **place)


def _draw_front(axes: Axes, bench: Bench, outcomes: Mapping[str, Outcome], cost: str) -> None:
    """Runs that none is both cheaper and more exact than, as a staircase."""
    points = costs_and_errors(bench, list(outcomes.values()), outcomes, cost)
    chosen = [points[i] for i in front(points)]
    if len(chosen) > 1:
        x, y = zip(*[(c, percent(e)) for c, e in chosen])
        axes.step(x, y, where="post", color=FRONT, lw=4, alpha=0.5, zorder=0, label="Pareto front")


def costs_and_errors(
    bench: Bench, chosen: Sequence[Outcome], outcomes: Mapping[str, Outcome], cost: str
) -> list[tuple[float, float]]:
    """Of the runs that did not fail; the reference itself, whose error is 0, is left out."""
    pairs = [(getattr(o, cost), error(bench, o, outcomes)) for o in chosen]
    return [(c, e) for c, e in pairs if math.isfinite(e) and e > 0.0 and c > 0]


def found(sweep: Sweep, outcomes: Mapping[str, Outcome]) -> list[tuple[Outcome, str]]:
    """Stored outcomes of a sweep that did not fail, with their labels."""
    pairs = [(outcomes.get(key(o)), label) for o, label in zip(sweep.options, sweep.labels)]
    return [(outcome, label) for outcome, label in pairs if outcome and not outcome.failure]


def percent(value: float) -> float:
    """For an axis that is logarithmic."""
    return 100.0 * max(value, EXACT)
