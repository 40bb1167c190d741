"""The sheave in a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from braidx.output.arrays import Array


@dataclass(frozen=True)
class SheavePicture:
    """A rigid sheave: a surface of revolution about its axis.

    At a distance u from its middle plane the radius is radius + g - sqrt(g^2 - u^2), g the radius
    of the groove; without a groove it is a cylinder.

    Raises:
        ValueError: If a vector has not three components or a radius is not positive.
    """

    centre: Array  # (3,), mm, on the axis in the middle plane
    axis: Array  # (3,), unit vector
    radius: float  # mm, where the rope lies: at the bottom of the groove
    groove_radius: float | None = None  # mm; None: flat
    angle: float = 0.0  # rad, turned since the start, right-handed about the axis

    def __post_init__(self) -> None:
        for name in ("centre", "axis"):
            found = np.shape(getattr(self, name))
            if found != (3,):
                raise ValueError(f"SheavePicture.{name}: {found}, expected (3,).")
        groove = self.groove_radius
        if self.radius <= 0.0 or (groove is not None and groove <= 0.0):
            raise ValueError(
                f"SheavePicture: radius {self.radius} mm, groove {groove}; give positive radii."
            )

    def profile(self, across: Array) -> Array:
        """Radius at distances from the middle plane along the axis, mm, NaN beyond the groove."""
        groove = self.groove_radius
        if groove is None:
            return np.full(np.shape(across), self.radius)
        inside = np.abs(across) <= groove
        depth = np.sqrt(np.where(inside, groove**2 - across**2, 0.0))
        radius: Array = np.where(inside, self.radius + groove - depth, np.nan)
        return radius
