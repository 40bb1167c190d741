"""Heat in a rope that is bent again and again: friction warms it, its surface gives heat off."""

from .material import ThermalMaterial
from .rope_heat import HeatHistory, RopeHeat
from .source import crossing_powers, spread

__all__ = ["HeatHistory", "RopeHeat", "ThermalMaterial", "crossing_powers", "spread"]
