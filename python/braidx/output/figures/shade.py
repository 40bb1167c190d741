"""Light and shadow for ray-cast tubes."""

from __future__ import annotations

import numpy as np

from braidx.output.figures.raycast import Hits, Tubes, View, cast
from braidx.output.snapshot import Array

_LIGHT = np.array([-0.35, 0.65, 0.68])  # from the upper left, in front
_HALF = (_LIGHT + (0.0, 0.0, 1.0)) / np.linalg.norm(_LIGHT + (0.0, 0.0, 1.0))


def render(tubes: Tubes, view: View, supersample: int = 2) -> Array:
    """Picture of tubes, shape (rows, columns, 4): red, green, blue, opacity, 0..1.

    Args:
        tubes: What is shown.
        view: From where; its pixels are those of the result.
        supersample: Rays per pixel in either direction.
    """
    rows, columns = view.shape
    fine = View(
        view.right,
        view.up,
        view.centre,
        columns / view.pixels_per_mm,
        rows / view.pixels_per_mm,
        view.pixels_per_mm * supersample,
        view.cut_depth,
    )
    hits = cast(tubes, fine)
    seen = hits.cylinder >= 0
    picture = np.zeros((*seen.shape, 4))
    if seen.any():
        colour = tubes.colour[hits.cylinder] * _brightness(hits, tubes, fine)[..., None]
        shine = 0.16 * np.clip(hits.normal @ _HALF, 0.0, 1.0) ** 24 * ~hits.is_cut
        picture[..., :3] = np.where(seen[..., None], np.clip(colour + shine[..., None], 0, 1), 0.0)
        picture[..., 3] = seen
    picture = picture.reshape(rows, supersample, columns, supersample, 4)
    opacity = picture[..., 3:].mean(axis=(1, 3))
    mean = picture[..., :3].mean(axis=(1, 3)) / np.maximum(opacity, 1e-9)
    return np.concatenate([mean, opacity], axis=2)


def _brightness(hits: Hits, tubes: Tubes, view: View) -> Array:
    """Diffuse light, dimmed in the grooves between tubes."""
    diffuse = 0.38 + 0.68 * np.clip(0.3 + 0.7 * (hits.normal @ _LIGHT), 0.0, 1.0)
    diffuse = np.where(hits.is_cut, 1.06, diffuse)
    radius = float(np.median(tubes.radius))
    seen = hits.cylinder >= 0
    floor = hits.depth[seen].min()
    depth = np.where(seen, hits.depth, floor)
    open_sky = np.ones_like(depth)
    for reach in (0.6, 2.0):
        size = max(int(round(reach * radius * view.pixels_per_mm)), 1)
        # How much lower a point lies than its neighbourhood, in radii.
        lower = (_blur(np.maximum(depth, floor), size) - depth) / (reach * radius)
        open_sky *= 1.0 - 0.55 * np.clip(lower, 0.0, 1.0)
    brightness: Array = diffuse * open_sky
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
