"""Parallel projections of space onto the pixels of a picture."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from braidx.output.arrays import Array


@dataclass(frozen=True)
class View:
    """Parallel projection of a box of space onto pixels."""

    right: Array  # (3,), unit
    up: Array  # (3,), unit, across right
    centre: Array  # (3,), mm, in the middle of the picture
    width: float  # mm
    height: float  # mm
    pixels_per_mm: float
    cut_depth: float = np.inf  # mm towards the eye from `centre`; what lies nearer is cut away

    @property
    def axes(self) -> Array:
        """Rows right, up, towards the eye, shape (3, 3)."""
        return np.stack([self.right, self.up, np.cross(self.right, self.up)])

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the picture."""
        rows = max(int(round(self.height * self.pixels_per_mm)), 1)
        return rows, max(int(round(self.width * self.pixels_per_mm)), 1)

    def finer(self, times: int) -> View:
        """The same view with so many pixels for one in either direction."""
        rows, columns = self.shape
        return replace(
            self,
            width=columns / self.pixels_per_mm,
            height=rows / self.pixels_per_mm,
            pixels_per_mm=self.pixels_per_mm * times,
        )


def frame(towards: Array, up: Array) -> Array:
    """Unit vectors to the right, upwards and towards the eye, shape (3, 3).

    Args:
        towards: Direction from the scene to the eye, shape (3,).
        up: Direction that is upwards in the picture, as nearly as `towards` allows; where both are parallel the
            axis of space that is most across takes its place.
    Raises:
        ValueError: If `towards` has no direction.
    """
    length = np.linalg.norm(towards)
    if not np.isfinite(length) or length == 0.0:
        raise ValueError(
            f"towards = {tuple(towards)} has no direction: give three numbers, not all 0"
        )
    eye = np.asarray(towards, dtype=float) / length
    right = np.cross(up, eye)
    # Directions closer than a thousandth of a radian cannot be told from parallel ones in a picture.
    if np.linalg.norm(right) < 1e-3 * max(float(np.linalg.norm(up)), 1e-300):
        right = np.cross(np.eye(3)[np.argmin(np.abs(eye))], eye)
    right = right / np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])
