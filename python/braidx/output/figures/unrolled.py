"""Axes of the unrolled rope: place along the axis against angle about it."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from braidx.output.arrays import Array
from braidx.output.figures.style import GREY, INK

_OPENED = -195.0  # degrees from the sheave: a little past the side away from it


def unrolled(ax: Axes, low: float, high: float, crown: float) -> None:
    """Limits, ticks and names of the sides; the rope is cut open at the side away from the sheave."""
    margin = 0.015 * (high - low)
    ax.set_xlim(low - margin, high + margin)
    ax.set_ylim(_OPENED, _OPENED + 360)
    ax.set_yticks([-180, -90, 0, 90])
    ax.axvline(crown, color=GREY, lw=0.8, ls=":")
    ax.axhline(0.0, color=GREY, lw=0.8, ls=":")
    ax.text(crown, 1.01, "crown", color=GREY, ha="center", transform=ax.get_xaxis_transform())
    for angle, name in ((-180, "away"), (0, "sheave")):
        place = (angle - _OPENED) / 360
        ax.text(1.006, place, name, color=INK, va="center", transform=ax.transAxes)
    ax.set_ylabel("angle from the sheave (degrees)")


def from_sheave(angle: Array) -> Array:
    """Angles about the axis counted from x, rad, as degrees from the side of the sheave, -195 to 165."""
    degrees: Array = np.remainder(np.rad2deg(angle) + 90.0 - _OPENED, 360.0) + _OPENED
    return degrees
