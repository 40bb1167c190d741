"""The section of a bent rope at its crown, on the sheave (paper 2, fig. 12)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle, Patch

from braidx.output.bending_measures import crown_of, skin_slices
from braidx.output.cuts import cut
from braidx.output.figures.shapes import CORE_COLOUR
from braidx.output.figures.style import (
    AMBER,
    BLUE,
    INK,
    LAYER_NAMES,
    figure,
    panels,
    save,
    styled,
    yarn_colours,
)
from braidx.output.measures import layers
from braidx.output.snapshot import Array, Snapshot

_SHEAVE_COLOUR = "#c3c7cd"


@styled
def draw_crown_section(snapshot: Snapshot, path: Path) -> Path:
    """Sections of yarns and core in the plane across the rope through its crown, and the sheave.

    The crown stays in the plane z = crown, which the rope crosses at right angles there.
    """
    crown = crown_of(snapshot)
    outlines, owners = crown_outlines(snapshot, crown)
    colours = np.concatenate([yarn_colours(snapshot), [CORE_COLOUR]])[owners]
    everything = np.concatenate(outlines)
    low, high = everything.min(axis=0), everything.max(axis=0)
    half = 0.58 * float(max(high - low))
    middle = 0.5 * (low + high)
    bottom = low[1] - 0.35 * half
    page = figure(6.2, 6.2 * (middle[1] + half - bottom) / (2 * half) + 0.5)
    (ax,) = panels(page, 1, 1)
    _draw_sheave(ax, snapshot, middle[0] + half * np.linspace(-1, 1, 401), bottom)
    _draw_core(ax, snapshot, crown)
    order = np.argsort(owners)  # the core first: yarns lie on it
    ax.add_collection(
        PolyCollection(
            [outlines[i] for i in order],
            facecolors=colours[order],
            edgecolors="white",
            lw=0.7,
            alpha=0.95,
        )
    )
    ax.set_xlim(middle[0] - half, middle[0] + half)
    ax.set_ylim(bottom, middle[1] + half)
    ax.set_aspect("equal")
    size = high - low
    ax.set_title(
        f"{snapshot.state}: section at the crown, z = {crown:.1f} mm,\n"
        f"{size[0]:.2f} mm wide and {size[1]:.2f} mm high"
    )
    ax.set_xlabel("x (mm)")
    ax.set_ylabel("y (mm)")
    patches = [Patch(color=c, label=n) for c, n in zip((BLUE, AMBER), LAYER_NAMES)]
    if len(np.unique(layers(snapshot))) == 2:
        ax.legend(handles=patches, loc="upper center", bbox_to_anchor=(0.5, -0.09), ncols=2)
    return save(page, path)


def crown_outlines(snapshot: Snapshot, crown: float) -> tuple[list[Array], Array]:
    """Outlines (n, 2) of all that is cut by z = crown, and the owner of each, -1 for the core."""
    slices = skin_slices(snapshot, np.array([0.0, 0.0, crown]), np.array([0.0, 0.0, 1.0]))
    outlines = [piece.outline[:, :2] for piece in slices]
    owners = [piece.owner for piece in slices]
    section = cut(snapshot, crown)
    for outline, yarn in zip(section.outlines(64), section.yarn):
        if yarn not in owners:
            outlines.append(np.asarray(outline))
            owners.append(int(yarn))
    return outlines, np.array(owners, dtype=np.int64)


def _draw_core(ax: Axes, snapshot: Snapshot, crown: float) -> None:
    """A core without a skin: a ring about where its line passes through the plane."""
    core = snapshot.core
    if core is None or any((skin.owner == -1).any() for skin in snapshot.skins):
        return
    line = core.line
    at = int(np.argmin(np.abs(line[:, 2] - crown)))
    middle = (float(line[at, 0]), float(line[at, 1]))
    ax.add_patch(Circle(middle, core.radius, facecolor=CORE_COLOUR, edgecolor=INK, lw=0.7))
    if core.inner_radius > 0.0:
        ax.add_patch(Circle(middle, core.inner_radius, facecolor="white", edgecolor=INK, lw=0.7))


def _draw_sheave(ax: Axes, snapshot: Snapshot, x: Array, bottom: float) -> None:
    """The surface that the rope lies on; the axis of the sheave is x."""
    sheave = snapshot.sheave
    if sheave is None:
        return
    top = sheave.centre[1] + sheave.profile(x - sheave.centre[0])
    ax.fill_between(x, bottom, top, where=np.isfinite(top).tolist(), color=_SHEAVE_COLOUR, lw=0)
    ax.plot(x, top, color=INK, lw=0.8)
    ax.text(float(x[200]), bottom + 0.04 * float(np.ptp(x)), "sheave", ha="center", color=INK)
