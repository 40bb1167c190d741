"""The heat of a rope that is bent again and again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.fields import Table, option


@dataclass(frozen=True)
class Heat(Table):
    """Heat of friction in a rope that bends cyclically: how often it bends, and where the heat goes."""

    table: ClassVar[str] = "heat"

    frequency: float = option(unit="Hz", above=0.0, doc="Bending cycles per second.")
    cycles: int = option(1000, minimum=1, doc="Cycles that the temperature is computed for.")
    conductivity_axial: float = option(
        20.0, unit="W/(m K)", above=0.0, doc="Conductivity along the rope, along the filaments."
    )
    conductivity_radial: float = option(
        0.2, unit="W/(m K)", above=0.0, doc="Conductivity across the rope, across the filaments."
    )
    density: float = option(970.0, unit="kg/m^3", above=0.0, doc="Density.")
    heat_capacity: float = option(1850.0, unit="J/(kg K)", above=0.0, doc="Heat capacity.")
    convection: float = option(
        10.0, unit="W/(m^2 K)", above=0.0, doc="Heat transfer at the rope's surface."
    )
    ambient: float = option(
        20.0,
        unit="degrees C",
        above=-273.15,
        doc="Temperature of the air, and of the rope at first.",
    )
