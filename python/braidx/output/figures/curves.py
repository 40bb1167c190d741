"""Charts: force against strain, distribution of yarn stress, course of the computation."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.ticker import LogLocator, NullLocator
from numpy.typing import NDArray

from braidx.output import history
from braidx.output.figures.style import (
    AMBER,
    BLUE,
    GREY,
    INK,
    figure,
    panels,
    save,
    styled,
)
from braidx.output.measures import interior_stress, linear_fit, yarn_stress
from braidx.output.snapshot import Array, Snapshot
from braidx.output.summary import Expected

Columns = dict[str, NDArray[np.generic]]


def pulled(columns: Columns) -> tuple[Array, Array]:
    """Strain (-) and force (kN) of the increments in which the rope was pulled.

    Left out are increments without strain or force and the steps in which the strain is constant.
    """
    strain = np.asarray(columns["rope strain (-)"], dtype=float)
    force = np.asarray(columns["force (kN)"], dtype=float)
    step = columns["step"]
    keep = np.isfinite(strain) & np.isfinite(force)
    for name in np.unique(step):
        here = keep & (step == name)
        if here.any() and np.ptp(strain[here]) == 0.0:
            keep &= step != name
    return strain[keep], force[keep]


@styled
def draw_force_strain(history_path: Path, path: Path, reference: Expected | None = None) -> Path:
    """Force against strain with the fitted slope and the reference's (paper 1, fig. 15).

    Args:
        history_path: history.csv of the run.
        path: Where the figure goes.
        reference: Expected axial stiffness, kN; drawn through the middle of the linear part.
    Raises:
        ValueError: If the rope was not pulled.
    """
    strain, force = pulled(history.read(history_path))
    if len(strain) < 2:
        raise ValueError("history.csv: no increment in which the rope was pulled.")
    page = figure(7.2, 5.0)
    (ax,) = panels(page, 1, 1)
    ax.plot(100 * strain, force, "o-", color=BLUE, ms=3.5, lw=1.6, label="computed")
    fit = linear_fit(strain, force)
    span = np.array([fit.offset, fit.last_strain])
    ax.plot(
        100 * span,
        fit.stiffness * (span - fit.offset),
        color=INK,
        lw=1.0,
        ls="--",
        label=f"fitted slope: {fit.stiffness:.0f} kN",
    )
    if reference is not None:
        middle = 0.5 * (fit.first_strain + fit.last_strain)
        offset = middle - fit.stiffness * (middle - fit.offset) / reference.reference
        line = np.array([offset, fit.last_strain])
        ax.plot(
            100 * line,
            reference.reference * (line - offset),
            color=AMBER,
            lw=1.6,
            label=f"reference slope: {reference.reference:.0f} kN ({reference.source})",
        )
    ax.axvspan(
        100 * fit.first_strain,
        100 * fit.last_strain,
        color=GREY,
        alpha=0.12,
        lw=0,
        label="linear part",
    )
    ax.set_xlabel("rope strain (%)")
    ax.set_ylabel("force (kN)")
    ax.set_ylim(bottom=min(0.0, float(force.min())))
    ax.grid(True)
    ax.set_axisbelow(True)
    ax.legend(loc="upper left")
    return save(page, path)


@styled
def draw_stress_histogram(snapshots: Sequence[Snapshot], path: Path) -> Path:
    """Share of the yarns' length per axial stress (paper 1, fig. 20).

    Raises:
        ValueError: If a snapshot has no axial stress.
    """
    page = figure(7.2, 4.4)
    (ax,) = panels(page, 1, 1)
    data = [interior_stress(snapshot) for snapshot in snapshots]
    values = np.concatenate([stress for stress, _ in data])
    spread = max(float(np.ptp(values)), 1e-6)
    edges = np.linspace(values.min() - 0.02 * spread, values.max() + 0.02 * spread, 41)
    for snapshot, colour, (stress, length) in zip(snapshots, (BLUE, AMBER, GREY), data):
        found = yarn_stress(snapshot)
        label = f"{snapshot.state}: mean {found.mean:.0f}, standard deviation {found.std:.0f} MPa"
        weight = 100 * length / length.sum()
        ax.hist(stress, list(edges), weights=weight, color=colour, alpha=0.75, label=label)
        ax.axvline(found.mean, color=INK, lw=1.0, ls="--")
    ax.set_xlabel("axial stress of the yarn (MPa)")
    ax.set_ylabel("share of the yarns' length (%)")
    ax.legend(loc="upper left")
    ax.margins(y=0.2)
    return save(page, path)


@styled
def draw_course(history_path: Path, path: Path) -> Path:
    """Newton iterations, contact elements, penetration, stabilisation and seconds per increment."""
    columns = history.read(history_path)
    increment = np.asarray(columns["increment"], dtype=float)
    step = columns["step"]
    charts = (
        ("Newton iterations", "Newton iterations (-)", 1.0),
        ("contact elements", "contact elements (-)", 1.0),
        ("max penetration / radius (-)", "largest penetration\n(% of radius)", 100.0),
        (
            "stabilisation residual share (-)",
            "stabilisation residual\n(% of internal energy)",
            100.0,
        ),
        ("seconds", "time (s)", 1.0),
    )
    page = figure(9.0, 10.0)
    axes = panels(page, len(charts), 1, sharex=True)
    for ax, (column, label, factor) in zip(axes, charts):
        values = factor * np.asarray(columns[column], dtype=float)
        if column in ("Newton iterations", "seconds"):
            ax.bar(increment, values, width=0.8, color=BLUE)
        else:
            ax.plot(increment, values, "o-", color=BLUE, ms=2.5, lw=1.3)
        ax.set_ylabel(label)
        if "penetration" in column and (values > 0.0).any():
            ax.set_yscale("log")
            ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            ax.yaxis.set_major_formatter("{x:g}")
            ax.yaxis.set_minor_locator(NullLocator())
        else:
            ax.set_ylim(bottom=0.0)
        ax.grid(True, axis="y")
        ax.set_axisbelow(True)
        for border in np.flatnonzero(step[1:] != step[:-1]):
            ax.axvline(increment[border] + 0.5, color=GREY, lw=0.8, ls=":")
    for first in [0, *(1 + np.flatnonzero(step[1:] != step[:-1]))][: len(step)]:
        axes[0].annotate(
            str(step[first]),
            (increment[first] - 0.4, 1.02),
            color=GREY,
            xycoords=("data", "axes fraction"),
            va="bottom",
        )
    axes[-1].set_xlabel("increment (-)")
    return save(page, path)
