"""Constants of a beam's section."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class BeamSection:
    """Constants of a section; they may be chosen independently of a shape.

    Raises:
        ValueError: If a constant is not positive.
    """

    area: float  # A, mm^2
    inertia_1: float  # integral of xi1^2, resists bending in the plane of director 1, mm^4
    inertia_2: float  # integral of xi2^2, mm^4
    torsion_constant: float  # J, mm^4
    shear_area: float  # resists shear between axis and section, mm^2

    def __post_init__(self) -> None:
        for name in self.__dataclass_fields__:
            if not getattr(self, name) > 0.0:
                raise ValueError(f"{name} is {getattr(self, name)}: it must be positive")

    @classmethod
    def round(cls, radius: float) -> BeamSection:
        """Solid round section of `radius` mm; torsion is exact, shear stress taken as uniform."""
        area, inertia = math.pi * radius**2, math.pi * radius**4 / 4.0
        return cls(area, inertia, inertia, 2.0 * inertia, area)
