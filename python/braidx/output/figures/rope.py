"""Pictures of the rope in space (paper 1, figures 7, 8 and 16)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from braidx.output.cuts import node_tangents
from braidx.output.figures.raycast import Tubes, View
from braidx.output.figures.shade import render
from braidx.output.figures.style import INK, figure, panels, save, styled, yarn_colours
from braidx.output.measures import extent, interior_stress, outer_diameter
from braidx.output.snapshot import Array, Snapshot

_X, _Y, _Z = np.eye(3)
PIXELS_ACROSS = 1500  # of a rope lying along the page
_STRESS_MAP = colormaps["viridis"]


def tubes(
    snapshot: Snapshot, colours: Sequence[Array], yarns: Sequence[int] | None = None
) -> Tubes:
    """Round tubes along smoothed centre lines.

    Args:
        snapshot: The rope.
        colours: Per yarn one colour, shape (1, 3), or one per segment, shape (n_i - 1, 3), which
            then changes smoothly from segment to segment.
        yarns: The yarns to show; None shows all.
    """
    chosen = list(range(snapshot.num_yarns) if yarns is None else yarns)
    return tubes_along(
        [snapshot.centre_lines[yarn] for yarn in chosen],
        [float(snapshot.radius[yarn]) for yarn in chosen],
        [colours[yarn] for yarn in chosen],
    )


def tubes_along(lines: Sequence[Array], radii: Sequence[float], colours: Sequence[Array]) -> Tubes:
    """Round tubes along smoothed lines, shape (n_i, 3) each, mm; colours as in `tubes`."""
    rows: list[tuple[Array, ...]] = []
    for line, radius, given in zip(lines, radii, colours, strict=True):
        spacing = float(np.linalg.norm(np.diff(line, axis=0), axis=1).mean())
        pieces = int(np.clip(round(spacing / (1.5 * radius)), 1, 8))
        smooth = hermite(line, pieces)
        tangent = node_tangents(smooth)
        count = len(smooth) - 1
        place = np.linspace(0.5 / pieces, len(line) - 1 - 0.5 / pieces, count)
        known = 0.5 + np.arange(len(given))
        colour = np.stack([np.interp(place, known, channel) for channel in given.T], axis=1)
        reach = np.full(count, radius)
        rows.append((smooth[:-1], smooth[1:], tangent[:-1], tangent[1:], reach, colour))
    return Tubes(*(np.concatenate(column) for column in zip(*rows)))


def hermite(line: Array, pieces: int) -> Array:
    """Cubic through the nodes of a line, `pieces` stretches per segment."""
    chord = np.linalg.norm(np.diff(line, axis=0), axis=1)[:, None]
    tangent = node_tangents(line)
    parts = []
    for s in np.arange(pieces) / pieces:
        parts.append(
            (1 + 2 * s) * (1 - s) ** 2 * line[:-1]
            + s * (1 - s) ** 2 * chord * tangent[:-1]
            + s**2 * (3 - 2 * s) * line[1:]
            - s**2 * (1 - s) * chord * tangent[1:]
        )
    return np.concatenate([np.stack(parts, axis=1).reshape(-1, 3), line[-1:]])


@styled
def draw_forming(snapshots: Sequence[Snapshot], path: Path) -> Path:
    """The rope before, during and after forming, seen from the side."""
    half = max(_half_width(snapshot) for snapshot in snapshots)
    low, high = extent(snapshots[-1])
    length = min(high - low, 12.0 * half)
    page = figure(12.0, 0.35 + len(snapshots) * (0.5 + 11.2 * 2 * half / length))
    axes = panels(page, len(snapshots), 1, sharex=True)
    for ax, snapshot in zip(axes, snapshots):
        shown = tubes(snapshot, list(yarn_colours(snapshot)[:, None]))
        # From the first end: until it is laid end to end the rope is one pitch long.
        _side_view(ax, shown, low + 0.5 * length, length, half)
        ax.set_title(f"{snapshot.name}: outer diameter {outer_diameter(snapshot):.2f} mm")
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
    ax.imshow(render(tubes(snapshot, list(yarn_colours(snapshot)[:, None])), view), extent=box)
    bar = float(2 * 10 ** np.floor(np.log10(half)))
    ax.plot([0, 0], [-0.5 * bar, 0.5 * bar], color=INK, lw=2.0, clip_on=False)
    ax.text(-0.008 * width, 0, f"{bar:g} mm", rotation=90, ha="right", va="center")
    ax.set_axis_off()
    diameter = outer_diameter(snapshot)
    ax.set_title(f"{snapshot.name}: {snapshot.num_yarns} yarns, outer diameter {diameter:.2f} mm")
    return save(page, path)


@styled
def draw_stress(snapshot: Snapshot, path: Path) -> Path:
    """Yarns coloured by axial stress: the rope, a section along it, one strand (fig. 16).

    Raises:
        ValueError: If the snapshot has no axial stress.
    """
    inside, _ = interior_stress(snapshot)
    assert snapshot.axial_stress is not None
    scale = Normalize(*np.percentile(inside, [1, 99]))
    colours = [_STRESS_MAP(scale(stress))[:, :3] for stress in snapshot.axial_stress]
    half = _half_width(snapshot)
    low, high = extent(snapshot)
    middle, length = 0.5 * (low + high), min(high - low, 12.0 * half)
    strand = int(snapshot.strand[0])
    members = [int(yarn) for yarn in np.flatnonzero(snapshot.strand == strand)]
    whole = tubes(snapshot, colours)

    heights = [2 * half / (high - low), 2 * half / length, 2 * half / length]
    page = figure(12.0, 10.6 * sum(heights) + 2.0)
    axes = panels(page, 3, 1, height_ratios=heights)
    _side_view(axes[0], whole, middle, high - low, half)
    axes[0].set_title(f"{snapshot.name}: whole rope")
    _side_view(axes[1], whole, middle, length, half, cut_depth=0.0)
    axes[1].set_title("section along the rope's axis")
    _side_view(axes[2], tubes(snapshot, colours, members), middle, length, half)
    axes[2].set_title(f"strand {strand} alone")
    axes[2].set_xlabel("z (mm)")
    colour_bar = page.colorbar(
        ScalarMappable(scale, _STRESS_MAP), ax=axes, shrink=0.7, pad=0.01, extend="both"
    )
    colour_bar.set_label("axial stress of the yarn (MPa)")
    return save(page, path)


def _half_width(snapshot: Snapshot) -> float:
    """Half the width that shows the whole rope, mm."""
    far = (np.linalg.norm(line[:, :2], axis=1).max() for line in snapshot.centre_lines)
    return 1.04 * float(max(far) + snapshot.radius.max())


def _side_view(
    ax: Axes, shown: Tubes, middle: float, length: float, half: float, cut_depth: float = np.inf
) -> None:
    """Fill axes with a view across z, true to scale; x points away from the eye."""
    view = View(_Z, _Y, middle * _Z, length, 2 * half, PIXELS_ACROSS / length, cut_depth)
    box = (middle - 0.5 * length, middle + 0.5 * length, -half, half)
    ax.imshow(render(shown, view), extent=box, interpolation="antialiased")
    ax.set_ylabel("y (mm)")
