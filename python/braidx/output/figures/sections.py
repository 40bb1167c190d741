"""Cross-sections of the rope with the real cut of each yarn (paper 1, figures 7 and 14)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Circle, Patch

from braidx.output.cuts import Cut, cut
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
from braidx.output.measures import (
    circumscribed_diameter,
    extent,
    layers,
    outer_diameter,
    packing_fraction,
)
from braidx.output.snapshot import Snapshot


@styled
def draw_steps(snapshots: Sequence[Snapshot], path: Path) -> Path:
    """The section half way along the rope at several steps of the forming, side by side."""
    sections = [cut(snapshot, _middle(snapshot)) for snapshot in snapshots]
    half = 0.54 * max(circumscribed_diameter(section) for section in sections)
    page = figure(3.2 * len(snapshots) + 0.4, 3.9)
    axes = panels(page, 1, len(snapshots), sharey=True)
    for ax, snapshot, section in zip(axes, snapshots, sections):
        _draw(ax, snapshot, section, half)
        ax.set_title(f"{snapshot.state}\nouter diameter {outer_diameter(snapshot):.2f} mm")
        ax.set_xlabel("x (mm)")
    axes[0].set_ylabel("y (mm)")
    return save(page, path)


@styled
def draw_section(snapshot: Snapshot, path: Path) -> Path:
    """One section with the smallest circle about the rope's axis around it (fig. 14), and the outer diameter."""
    section = cut(snapshot, _middle(snapshot))
    diameter = circumscribed_diameter(section)
    half = 0.56 * diameter
    page = figure(6.2, 6.6)
    (ax,) = panels(page, 1, 1)
    _draw(ax, snapshot, section, half)
    ax.add_patch(Circle((0, 0), 0.5 * diameter, fill=False, color=INK, lw=1.0, ls=(0, (5, 3))))
    ax.annotate(
        "",
        xy=(0.5 * diameter, 0),
        xytext=(-0.5 * diameter, 0),
        arrowprops={"arrowstyle": "<->", "color": INK, "lw": 1.1, "shrinkA": 0, "shrinkB": 0},
    )
    label = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 2.0}
    ax.text(0, 0, f"{diameter:.2f} mm", ha="center", va="center", fontsize=11, bbox=label)
    ax.set_title(
        f"{snapshot.state}: section at z = {section.z:.1f} mm\n"
        f"outer diameter of the rope (girth / pi) {outer_diameter(snapshot):.2f} mm;\n"
        f"yarns fill {100 * packing_fraction(section):.0f} % of the smallest circle about the axis (dashed)"
    )
    ax.set_xlabel("x (mm)")
    ax.set_ylabel("y (mm)")
    present = np.unique(layers(snapshot))
    if len(present) == 2:
        patches = [Patch(color=c, label=n) for c, n in zip((BLUE, AMBER), LAYER_NAMES)]
        ax.legend(handles=patches, loc="upper center", bbox_to_anchor=(0.5, -0.09), ncols=2)
    return save(page, path)


def _middle(snapshot: Snapshot) -> float:
    low, high = extent(snapshot)
    return 0.5 * (low + high)


def _draw(ax: Axes, snapshot: Snapshot, section: Cut, half: float) -> None:
    colours = yarn_colours(snapshot)[section.yarn]
    ellipses = PolyCollection(
        list(section.outlines(64)), facecolors=colours, edgecolors="white", lw=0.5, alpha=0.92
    )
    ax.add_collection(ellipses)
    ax.set_xlim(-half, half)
    ax.set_ylim(-half, half)
    ax.set_aspect("equal")
