"""The figure of the study of bedding-in cycles."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from load_cycles import load_cycles
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
from pulled_values import curve_of
from study_runs import Outcome

from braidx.output.figures.style import AMBER, BLUE, GREY, figure, save, styled
from braidx.scene import load_scene


def draw(outcomes: Sequence[Outcome], folder: Path) -> None:
    """study_bedding_in.png: the curve, and per cycle what is lost and what strain is left (figure 12b of paper 1)."""
    _draw(outcomes[0], folder / "study_bedding_in.png")


@styled
def _draw(outcome: Outcome, path: Path) -> Path:
    page = figure(10.0, 5.6)
    grid = page.add_gridspec(2, 5)
    _curve(outcome, page.add_subplot(grid[:, :3]))
    cycles = load_cycles(curve_of(outcome.folder))
    length = load_scene(outcome.folder / "scene.toml").length
    number = np.arange(1, len(cycles) + 1)
    lost = page.add_subplot(grid[0, 3:])
    hysteresis = [cycle.hysteresis for cycle in cycles]
    friction = [cycle.friction_work / length for cycle in cycles]
    lost.bar(number - 0.2, hysteresis, 0.38, color=BLUE, label="hysteresis")
    lost.bar(number + 0.2, friction, 0.38, color=AMBER, label="work of friction")
    lost.set(ylabel="work per cycle (J per m)", title="Work lost")
    lost.legend(loc="upper right")
    left = page.add_subplot(grid[1, 3:])
    left.plot(number, [100.0 * cycle.residual_strain for cycle in cycles], "o-", color=BLUE)
    left.set(
        xlabel="cycle",
        ylabel="strain (%)",
        title="Residual strain after a cycle",
        xlim=lost.get_xlim(),
    )
    left.set_ylim(bottom=0.0)
    left.margins(y=0.15)
    for ax in (lost, left):
        ax.xaxis.set_major_locator(MaxNLocator(integer=True))
        ax.grid(True, axis="y")
        ax.set_axisbelow(True)
    return save(page, path)


def _curve(outcome: Outcome, ax: Axes) -> None:
    curve = curve_of(outcome.folder)
    cycles = load_cycles(curve)
    shades = colormaps["viridis"](np.linspace(0.0, 0.85, len(cycles)))
    ax.plot(
        100.0 * curve.strain, curve.force, color=GREY, lw=1.2, label="pulled on after the cycles"
    )
    for number, (cycle, shade) in enumerate(zip(cycles, shades), 1):
        for branch in (cycle.loading, cycle.unloading):
            ax.plot(100.0 * branch.strain, branch.force, color=shade, lw=1.3)
        ax.plot([], [], color=shade, lw=1.3, label=f"cycle {number}")
    ax.set(xlabel="strain from the formed rope (%)", ylabel="force (kN)")
    ax.set_title("Bedding-in cycles and the pull after them")
    ax.set_ylim(bottom=0.0)
    ax.grid(True)
    ax.legend(loc="upper left")
