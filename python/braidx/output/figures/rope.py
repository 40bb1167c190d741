"""Pictures of the rope in space (paper 1, figures 7, 8 and 16)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable

from braidx.output.figures.shade import render
from braidx.output.figures.shapes import STRESS_MAP, scale_of, shapes
from braidx.output.figures.style import INK, figure, panels, save, styled
from braidx.output.figures.triangles import Triangles
from braidx.output.figures.view import View
from braidx.output.measures import extent, interior_stress, outer_diameter
from braidx.output.snapshot import Snapshot

_X, _Y, _Z = np.eye(3)
PIXELS_ACROSS = 1200  # of a rope lying along the page


@styled
def draw_forming(snapshots: Sequence[Snapshot], path: Path) -> Path:
    """The rope before, during and after forming, seen from the side."""
    half = max(_half_width(snapshot) for snapshot in snapshots)
    low, high = extent(snapshots[-1])
    length = min(high - low, 12.0 * half)
    page = figure(12.0, 0.35 + len(snapshots) * (0.5 + 11.2 * 2 * half / length))
    axes = panels(page, len(snapshots), 1, sharex=True)
    for ax, snapshot in zip(axes, snapshots):
        shown = shapes(snapshot)
        # From the first end: until it is laid end to end the rope is one pitch long.
        _side_view(ax, snapshot, shown, low + 0.5 * length, length, half)
        ax.set_title(f"{snapshot.state}: outer diameter {outer_diameter(snapshot):.2f} mm")
    axes[-1].set_xlabel(f"z (mm), {length:.0f} of {high - low:.0f} mm shown")
    return save(page, path)


@styled
def draw_oblique(snapshot: Snapshot, path: Path) -> Path:
    """The rope from its front end, coloured by layer and strand."""
    half = _half_width(snapshot)
    low, high = extent(snapshot)
    length = min(high - low, 9.0 * half)
    angle = np.deg2rad(32.0)
    right = np.cos(angle) * _Z - np.sin(angle) * _X
    toward = np.cross(right, _Y)
    width = length * np.cos(angle) + 2.2 * half * np.sin(angle)
    front = low if toward[2] < 0 else high
    inward = 1.0 if front == low else -1.0
    centre = np.array([0.0, 0.0, front + inward * 0.5 * length])
    view = View(right, _Y, centre, width, 2.1 * half, PIXELS_ACROSS / width)
    page = figure(10.0, 10.0 * 2.1 * half / width + 0.3)
    (ax,) = panels(page, 1, 1)
    box = (0.0, width, -1.05 * half, 1.05 * half)
    ax.imshow(render(shapes(snapshot), view, float(np.median(snapshot.radius))), extent=box)
    bar = float(2 * 10 ** np.floor(np.log10(half)))
    ax.plot([0, 0], [-0.5 * bar, 0.5 * bar], color=INK, lw=2.0, clip_on=False)
    ax.text(-0.008 * width, 0, f"{bar:g} mm", rotation=90, ha="right", va="center")
    ax.set_axis_off()
    diameter = outer_diameter(snapshot)
    ax.set_title(f"{snapshot.state}: {snapshot.num_yarns} yarns, outer diameter {diameter:.2f} mm")
    return save(page, path)


@styled
def draw_stress(snapshot: Snapshot, path: Path) -> Path:
    """Yarns coloured by axial stress: the rope, a section along it, one strand (fig. 16).

    Raises:
        ValueError: If the snapshot has no axial stress.
    """
    inside, _ = interior_stress(snapshot)
    scale = scale_of(inside, snapshot.name)
    half = _half_width(snapshot)
    low, high = extent(snapshot)
    middle, length = 0.5 * (low + high), min(high - low, 12.0 * half)
    strand = int(snapshot.strand[0])
    members = [int(yarn) for yarn in np.flatnonzero(snapshot.strand == strand)]
    whole, alone = shapes(snapshot, scale), shapes(snapshot, scale, members)

    heights = [2 * half / (high - low), 2 * half / length, 2 * half / length]
    page = figure(12.0, 10.6 * sum(heights) + 2.0)
    axes = panels(page, 3, 1, height_ratios=heights)
    _side_view(axes[0], snapshot, whole, middle, high - low, half)
    axes[0].set_title(f"{snapshot.state}: whole rope")
    _side_view(axes[1], snapshot, whole, middle, length, half, cut_depth=0.0)
    axes[1].set_title("section along the rope's axis")
    _side_view(axes[2], snapshot, alone, middle, length, half)
    axes[2].set_title(f"strand {strand} alone")
    axes[2].set_xlabel("z (mm)")
    colour_bar = page.colorbar(
        ScalarMappable(scale, STRESS_MAP), ax=axes, shrink=0.7, pad=0.01, extend="both"
    )
    colour_bar.set_label("axial stress of the yarn (MPa)")
    return save(page, path)


def _half_width(snapshot: Snapshot) -> float:
    """Half the width that shows the whole rope, mm."""
    far = (np.linalg.norm(line[:, :2], axis=1).max() for line in snapshot.centre_lines)
    return 1.04 * float(max(far) + snapshot.radius.max())


def _side_view(
    ax: Axes,
    snapshot: Snapshot,
    shown: Sequence[Triangles],
    middle: float,
    length: float,
    half: float,
    cut_depth: float = np.inf,
) -> None:
    """Fill axes with a view across z, true to scale; x points away from the eye."""
    view = View(_Z, _Y, middle * _Z, length, 2 * half, PIXELS_ACROSS / length, cut_depth)
    box = (middle - 0.5 * length, middle + 0.5 * length, -half, half)
    picture = render(shown, view, float(np.median(snapshot.radius)))
    ax.imshow(picture, extent=box, interpolation="antialiased")
    ax.set_ylabel("y (mm)")
