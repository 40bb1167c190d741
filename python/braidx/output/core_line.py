"""The core of a rope in a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from braidx.output.arrays import Array


@dataclass(frozen=True)
class CoreLine:
    """A round core, solid or hollow, along its centre line.

    Raises:
        ValueError: If the line is no line or the radii are not 0 <= inner_radius < radius.
    """

    line: Array  # (n, 3), mm
    radius: float  # mm
    inner_radius: float = 0.0  # mm; 0 for a solid core

    def __post_init__(self) -> None:
        if np.ndim(self.line) != 2 or np.shape(self.line)[1] != 3 or len(self.line) < 2:
            raise ValueError(f"CoreLine.line: {np.shape(self.line)}, expected (n, 3) with n >= 2.")
        if not 0.0 <= self.inner_radius < self.radius:
            raise ValueError(
                f"CoreLine: inner radius {self.inner_radius} mm in a core of radius {self.radius}"
                " mm; give 0 <= inner_radius < radius."
            )
