"""Pictures of rods as they are."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from ..output.figures.shade import render
from ..output.figures.style import INK, figure, panels, save, styled
from ..output.figures.swept import swept
from ..output.figures.view import View, frame
from ..system.terms import Floats

PIXELS = 1400  # along the longer side
FRAME = 1.04  # of the scene: what the picture shows
_HUES = colormaps["tab10"]
_SCALE = colormaps["viridis"]


@styled
def draw_rods(
    lines: Sequence[Floats],
    radii: Sequence[float],
    path: Path,
    tension: Sequence[Floats] | None = None,
    towards: Sequence[float] = (1.0, -1.6, 0.9),
    up: Sequence[float] = (0.0, 0.0, 1.0),
) -> Path:
    """Rods from outside, true to scale, with a bar that tells it.

    Args:
        lines: Nodes of each rod, shape (num_nodes, 3), mm.
        radii: Of each, mm.
        path: Of the PNG.
        tension: Axial force of each element of each rod, N, to colour them by; a colour per rod without it.
        towards: Direction from the scene to the eye.
        up: Direction that is upwards in the picture, as nearly as `towards` allows; any if both are parallel.
    Returns:
        The path.
    """
    axes = frame(np.asarray(towards, dtype=float), np.asarray(up, dtype=float))
    low, high = _extent(lines, radii, axes)
    width, height = FRAME * (high - low)[:2]
    view = View(
        axes[0], axes[1], 0.5 * (low + high) @ axes, width, height, PIXELS / max(width, height)
    )
    scale = None if tension is None else Normalize(*_range(tension))
    colours = _colours(lines, tension, scale)
    shown = [swept(*rod) for rod in zip(lines, radii, colours, strict=True)]
    size = 9.0 / max(width, height)
    page = figure(max(3.0, size * width) + (1.2 if scale else 0.0), max(1.5, size * height) + 0.4)
    (ax,) = panels(page, 1, 1)
    ax.imshow(render(shown, view, float(np.median(radii))), extent=(0.0, width, 0.0, height))
    bar = float(10 ** np.floor(np.log10(0.4 * width)))
    ax.plot([0.0, bar], [-0.02 * height] * 2, color=INK, lw=2.0, clip_on=False)
    ax.text(0.5 * bar, -0.04 * height, f"{bar:g} mm", ha="center", va="top")
    ax.set_axis_off()
    if scale:
        page.colorbar(ScalarMappable(scale, _SCALE), ax=ax, shrink=0.7).set_label("tension (N)")
    return save(page, path)


def _extent(lines: Sequence[Floats], radii: Sequence[float], axes: Floats) -> tuple[Floats, Floats]:
    """Least and greatest coordinates of all rods along the axes of the picture, shape (3,) each, mm."""
    seen = [line @ axes.T for line in lines]
    low = np.min([line.min(axis=0) - r for line, r in zip(seen, radii, strict=True)], axis=0)
    high = np.max([line.max(axis=0) + r for line, r in zip(seen, radii, strict=True)], axis=0)
    return np.asarray(low), np.asarray(high)


def _range(tension: Sequence[Floats]) -> tuple[float, float]:
    whole = np.concatenate(list(tension))
    low, high = float(whole.min()), float(whole.max())
    return (low, high) if high > low else (low - 1.0, high + 1.0)


def _colours(
    lines: Sequence[Floats], tension: Sequence[Floats] | None, scale: Normalize | None
) -> list[Floats]:
    if tension is None or scale is None:
        return [np.array([_HUES(number % 10)[:3]]) for number in range(len(lines))]
    colours = []
    for line, values in zip(lines, tension, strict=True):
        per_span = np.repeat(values, (len(line) - 1) // len(values))
        colours.append(np.asarray(_SCALE(scale(per_span)))[:, :3])
    return colours
