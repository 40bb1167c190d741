"""Thermal properties of a rope taken as one homogeneous body."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields


@dataclass(frozen=True)
class ThermalMaterial:
    """Properties in the units of data sheets; the computation takes them in mm, s, W, J, K.

    Raises:
        ValueError: If a property other than the ambient temperature is not positive.
    """

    conductivity_axial: float  # W/(m K), along the rope
    conductivity_radial: float  # W/(m K), across it, yarns and air together
    density: float  # kg/m^3, mass of the rope over the volume of its cylinder
    heat_capacity: float  # J/(kg K)
    convection: float  # W/(m^2 K), from the surface into air
    ambient: float = 20.0  # degrees C

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not math.isfinite(value) or (field.name != "ambient" and value <= 0.0):
                raise ValueError(f"ThermalMaterial.{field.name}: {value}; give a positive number.")

    @property
    def along(self) -> float:
        """Conductivity along the axis, W/(mm K)."""
        return 1e-3 * self.conductivity_axial

    @property
    def across(self) -> float:
        """Conductivity across the axis, W/(mm K)."""
        return 1e-3 * self.conductivity_radial

    @property
    def capacity(self) -> float:
        """Heat capacity per volume, J/(mm^3 K)."""
        return 1e-9 * self.density * self.heat_capacity

    @property
    def transfer(self) -> float:
        """Heat transfer at the surface, W/(mm^2 K)."""
        return 1e-6 * self.convection
