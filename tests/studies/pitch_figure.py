"""The figure of the study of the pitch."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from pitch_angles import Angles, angles
from pulled_values import EFFICIENCY, STIFFNESS, curve_of, state_of
from study_runs import Outcome

from braidx.output.cuts import cut
from braidx.output.figures.style import AMBER, BLUE, GREY, INK, figure, save, styled
from braidx.output.measures import extent

GREEN, VIOLET = "#4f9a5d", "#8d6ab8"
COLOURS = (GREEN, VIOLET, AMBER, BLUE)  # as in figure 17: green, violet and blue
SECTIONS = 3  # ropes whose sections are drawn


@styled
def _draw(outcomes: Sequence[Outcome], path: Path) -> Path:
    page = figure(10.0, 7.6)
    grid = page.add_gridspec(2, 6, height_ratios=[1.15, 1.0])
    _curves(outcomes, page.add_subplot(grid[0, :3]))
    _stiffness(outcomes, angles(outcomes), page.add_subplot(grid[0, 3:]))
    # The first, the second and the last, as the paper's figure has them.
    shown = sorted({0, 1, len(outcomes) - 1})[:SECTIONS]
    axes = [page.add_subplot(grid[1, 2 * k : 2 * k + 2]) for k in range(len(shown))]
    for ax, k in zip(axes, shown):
        _section(outcomes[k], COLOURS[k % len(COLOURS)], ax)
    return save(page, path)


def draw(outcomes: Sequence[Outcome], folder: Path) -> None:
    """study_pitch.png: curves, stiffness over the helix angle, sections (figures 17 and 18 of paper 1)."""
    _draw(outcomes, folder / "study_pitch.png")


def _curves(outcomes: Sequence[Outcome], ax: Axes) -> None:
    for outcome, colour in zip(outcomes, COLOURS):
        curve = curve_of(outcome.folder)
        label = f"pitch {outcome.case.label} mm"
        ax.plot(100.0 * curve.strain, curve.force, "o-", color=colour, ms=2.5, lw=1.4, label=label)
    ax.set(xlabel="rope strain (%)", ylabel="force (kN)", title="Force and strain")
    ax.set_ylim(bottom=0.0)
    ax.grid(True)
    ax.legend(loc="upper left")


def _stiffness(outcomes: Sequence[Outcome], found: Angles, ax: Axes) -> None:
    stiffness = [outcome.values[STIFFNESS] for outcome in outcomes]
    ends = np.array([min(found.square), max(found.square)])
    ends += 0.08 * np.ptp(ends) * np.array([-1.0, 1.0])
    label = f"straight line, $R^2$ = {found.line.r_squared:.3f}"
    ax.plot(ends, found.line(ends), color=INK, lw=1.2, label=label)
    middle = np.mean(found.square), np.mean(stiffness)
    ax.plot(
        ends,
        middle[1] * ends / middle[0],
        "--",
        color=GREY,
        label="in proportion to $\\cos^2\\alpha$",
    )
    alone = [o.values[STIFFNESS] / o.values[EFFICIENCY] * e for o, e in zip(outcomes, found.yarns)]
    ax.plot(
        found.square,
        alone,
        "o",
        mfc="none",
        color=GREY,
        ms=6,
        label="by the yarns' directions alone",
    )
    for k, (x, y, colour) in enumerate(zip(found.square, stiffness, COLOURS)):
        ax.plot(x, y, "o", color=colour, ms=7)
        place, side = ((-8, -3), "right") if k % 2 else ((8, -3), "left")
        told = f"{outcomes[k].case.label} mm"
        box = {"fc": "white", "ec": "none", "pad": 0.5}
        ax.annotate(told, (x, y), place, textcoords="offset points", ha=side, bbox=box)
    ax.set(xlabel=r"$\cos^2\alpha$ (-)", ylabel="axial stiffness EA (kN)")
    ax.set_title("Stiffness over the helix angle (figure 18)")
    ax.grid(True)
    ax.legend(loc="upper left")


def _section(outcome: Outcome, colour: str, ax: Axes) -> None:
    """A section as the yarns' tubes have it, in the middle of the sample."""
    formed = state_of(outcome.folder, "formed")
    section = cut(formed, 0.5 * sum(extent(formed)))
    shapes = PolyCollection(section.outlines(), facecolor=colour, edgecolor="white", lw=0.4)
    ax.add_collection(shapes)
    reach = 1.05 * np.abs(section.outlines()).max()
    ax.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal", xlabel="mm")
    ax.set_title(f"formed, pitch {outcome.case.label} mm")
