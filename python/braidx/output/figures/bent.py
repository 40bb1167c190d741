"""Pictures of a rope bent over a sheave: from the side, cut along its axis, and aslant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from braidx.output.figures.shade import render
from braidx.output.figures.shapes import STRESS_MAP, Colouring, shapes, stress_scale
from braidx.output.figures.sheave_shape import sheave_surface
from braidx.output.figures.style import INK, figure, panels, save, styled
from braidx.output.figures.triangles import Triangles
from braidx.output.figures.view import View, frame
from braidx.output.rope_axis import axis_of
from braidx.output.snapshot import Array, Snapshot

PIXELS_ACROSS = 1300
_X, _Y, _Z = np.eye(3)
_ASLANT = np.array([-0.80, 0.42, 0.50])  # towards the eye


@styled
def draw_bent(snapshot: Snapshot, path: Path, colouring: Colouring = Colouring.YARN) -> Path:
    """The bent rope on its sheave from the side, and cut along its axis with the core in it.

    Raises:
        ValueError: If stress is asked for and the snapshot has none.
    """
    scale = stress_scale(snapshot) if colouring is Colouring.STRESS else None
    parts = shapes(snapshot, scale)
    low, high = _box(snapshot)
    aspect = (high[1] - low[1]) / (high[2] - low[2])
    page = figure(8.0, 2 * (7.4 * aspect + 0.5))
    axes = panels(page, 2, 1, sharex=True)
    _fill_side(axes[0], snapshot, parts, low, high)
    _fill_side(axes[1], snapshot, parts, low, high, cut=True)
    axes[0].set_title(f"{snapshot.state}: from the side{_over(snapshot)}")
    axes[1].set_title("cut along the rope's axis")
    axes[1].set_xlabel("z (mm)")
    if scale is not None:
        _colour_bar(axes, scale)
    return save(page, path)


@styled
def draw_aslant(snapshot: Snapshot, path: Path, colouring: Colouring = Colouring.YARN) -> Path:
    """The bent rope and its sheave seen aslant, with a bar for the scale.

    Raises:
        ValueError: If stress is asked for and the snapshot has none.
    """
    scale = stress_scale(snapshot) if colouring is Colouring.STRESS else None
    view = aslant_view([snapshot], PIXELS_ACROSS)
    page = figure(8.0, 7.6 * view.height / view.width + 0.4)
    (ax,) = panels(page, 1, 1)
    ax.imshow(bent_image(snapshot, view, scale), extent=(0, view.width, 0, view.height))
    bar = float(2 * 10 ** np.floor(np.log10(0.2 * view.width)))
    below = -0.02 * view.width
    ax.plot([0.0, bar], [below, below], color=INK, lw=2.0)
    ax.text(1.05 * bar, below, f"{bar:g} mm", ha="left", va="center")
    ax.set_ylim(2 * below, view.height)
    ax.set_axis_off()
    ax.set_title(f"{snapshot.state}: {snapshot.num_yarns} yarns{_over(snapshot)}")
    if scale is not None:
        _colour_bar([ax], scale)
    return save(page, path)


def bent_image(snapshot: Snapshot, view: View, scale: Normalize | None = None) -> Array:
    """Rope and sheave in a view, shape (rows, columns, 4)."""
    parts = shapes(snapshot, scale)
    if snapshot.sheave is not None:
        parts.insert(0, sheave_surface(snapshot.sheave, _rope_radius(snapshot)))
    return render(parts, view, float(np.median(snapshot.radius)))


def aslant_view(snapshots: list[Snapshot], pixels_across: int) -> View:
    """A view from above and aside in which all of the snapshots fit."""
    right, up, _ = frame(_ASLANT, _Y)
    reach = np.array([[np.inf, np.inf], [-np.inf, -np.inf]])
    margin = max(float(snapshot.radius.max()) for snapshot in snapshots) * 1.3
    for snapshot in snapshots:
        flat = _extremes(snapshot) @ np.stack([right, up], axis=1)
        reach[0] = np.minimum(reach[0], flat.min(axis=0) - margin)
        reach[1] = np.maximum(reach[1], flat.max(axis=0) + margin)
    size, middle = reach[1] - reach[0], 0.5 * (reach[0] + reach[1])
    centre = middle[0] * right + middle[1] * up
    return View(right, up, centre, size[0], size[1], pixels_across / size[0])


def _fill_side(
    ax: Axes,
    snapshot: Snapshot,
    parts: list[Triangles],
    low: Array,
    high: Array,
    cut: bool = False,
) -> None:
    """Fill axes with a view along x, true to scale."""
    size, middle = high - low, 0.5 * (low + high)
    depth = 0.0 if cut else np.inf
    centre = np.array([0.0, middle[1], middle[2]])
    view = View(_Z, _Y, centre, size[2], size[1], PIXELS_ACROSS / size[2], depth)
    glass = None
    if snapshot.sheave is not None:
        surface = sheave_surface(snapshot.sheave, _rope_radius(snapshot))
        if cut:
            parts = [surface, *parts]
        else:
            glass = surface
    radius = float(np.median(snapshot.radius))
    picture = render(parts, view, radius, glass=glass)
    ax.imshow(picture, extent=(low[2], high[2], low[1], high[1]), interpolation="antialiased")
    ax.set_ylabel("y (mm)")


def _box(snapshot: Snapshot) -> tuple[Array, Array]:
    """Corners of a box round rope and sheave, mm."""
    corners, margin = _extremes(snapshot), 1.3 * float(snapshot.radius.max())
    return corners.min(axis=0) - margin, corners.max(axis=0) + margin


def _extremes(snapshot: Snapshot) -> Array:
    """Points that rope and sheave lie between, shape (k, 3), mm."""
    points = [*snapshot.centre_lines, *(skin.points for skin in snapshot.skins)]
    if snapshot.sheave is not None:
        points.append(sheave_surface(snapshot.sheave, _rope_radius(snapshot)).points)
    return np.concatenate(points)


def _rope_radius(snapshot: Snapshot) -> float:
    """Half the outer diameter of the rope, mm."""
    axis = axis_of(snapshot)
    lines = zip(snapshot.centre_lines, snapshot.radius)
    return max(float(axis.unroll(line)[2].max() + radius) for line, radius in lines)


def _over(snapshot: Snapshot) -> str:
    if snapshot.sheave is None:
        return ""
    return f", over a sheave of {2.0 * snapshot.sheave.radius:g} mm"


def _colour_bar(axes: list[Axes], scale: Normalize) -> None:
    bar = axes[0].figure.colorbar(
        ScalarMappable(scale, STRESS_MAP), ax=axes, shrink=0.6, pad=0.02, extend="both"
    )
    bar.set_label("axial stress of the yarn (MPa)")
