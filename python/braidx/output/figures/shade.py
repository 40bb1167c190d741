"""Light and shadow for what a view sees of surfaces."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from braidx.output.arrays import Array
from braidx.output.figures.triangles import Fragments, Triangles, joined, rasterise
from braidx.output.figures.view import View

_LIGHT = np.array([-0.35, 0.65, 0.68], dtype=np.float32)  # from the upper left, in front
_HALF = (_LIGHT + (0.0, 0.0, 1.0)) / np.linalg.norm(_LIGHT + (0.0, 0.0, 1.0))


def render(
    parts: Sequence[Triangles],
    view: View,
    radius: float,
    supersample: int = 2,
    glass: Triangles | None = None,
    opacity: float = 0.45,
) -> Array:
    """Picture of surfaces, shape (rows, columns, 4): red, green, blue, opacity, 0..1.

    Args:
        parts: What is shown.
        view: From where; its pixels are those of the result.
        radius: How wide the grooves are that lie in shadow, mm.
        supersample: Rays per pixel in either direction.
        glass: A surface through which the parts behind it are seen.
        opacity: Fraction of the glass in the colour of what is seen through it.
    """
    fine = view.finer(supersample)
    seen = rasterise(joined(parts), fine)
    colour, covered = _shaded(seen, radius, fine), seen.covered
    if glass is not None:
        pane = rasterise(glass, fine)
        front = pane.covered & (pane.depth > seen.depth)
        share = np.where(front, np.where(covered, opacity, 1.0), 0.0)[..., None]
        colour = (1.0 - share) * colour + share * _shaded(pane, radius, fine)
        covered = covered | front
    rows, columns = view.shape
    blocks = (rows, supersample, columns, supersample)
    alpha = covered.reshape(blocks).mean(axis=(1, 3))[..., None]
    # What is not covered is black and adds nothing.
    mean = colour.reshape(*blocks, 3).mean(axis=(1, 3)) / np.maximum(alpha, 1e-9)
    return np.concatenate([mean, alpha], axis=2)


def _shaded(seen: Fragments, radius: float, view: View) -> Array:
    """Colours under the light; zero where nothing is seen."""
    if not seen.covered.any():
        return np.zeros_like(seen.colour)
    colour = seen.colour * _brightness(seen, radius, view)[..., None]
    gloss = np.clip(seen.normal @ _HALF, 0.0, 1.0) ** 8
    colour += (0.16 * gloss * gloss * gloss * (seen.covered & ~seen.is_cut))[..., None]
    shaded: Array = np.clip(colour, 0.0, 1.0)
    return shaded


def _brightness(seen: Fragments, radius: float, view: View) -> Array:
    """Diffuse light, dimmed in the grooves between parts."""
    diffuse = 0.38 + 0.68 * np.clip(0.3 + 0.7 * (seen.normal @ _LIGHT), 0.0, 1.0)
    diffuse = np.where(seen.is_cut, 1.06, diffuse)
    # Shadows are smooth: every second pixel will do.
    covered, depth = seen.covered[::2, ::2], seen.depth[::2, ::2]
    depth = np.where(covered, depth, depth[covered].min() if covered.any() else 0.0)
    open_sky = np.ones_like(depth)
    for reach in (0.6, 2.0):
        size = max(int(round(reach * radius * 0.5 * view.pixels_per_mm)), 1)
        # How much lower a point lies than its neighbourhood, in radii.
        lower = (_blur(depth, size) - depth) / (reach * radius)
        open_sky *= 1.0 - 0.55 * np.clip(lower, 0.0, 1.0)
    rows, columns = seen.depth.shape
    brightness: Array = diffuse * open_sky.repeat(2, axis=0)[:rows].repeat(2, axis=1)[:, :columns]
    return brightness


def _blur(values: Array, reach: int) -> Array:
    """Mean over a square of 2 reach + 1 pixels, edges repeated."""
    for axis in (0, 1):
        pad = [(reach + 1, reach) if a == axis else (0, 0) for a in (0, 1)]
        total = np.cumsum(np.pad(values, pad, mode="edge"), axis=axis)
        width = 2 * reach + 1
        count = values.shape[axis]
        ahead = np.take(total, np.arange(width, width + count), axis=axis)
        values = (ahead - np.take(total, np.arange(count), axis=axis)) / width
    return values
