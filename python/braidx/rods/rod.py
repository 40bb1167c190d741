"""What a rod is: its centre line at rest, its section and what it is made of."""

from __future__ import annotations

from dataclasses import astuple, dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from ..bodies import BeamSection, YarnMaterial
from ..forms.materials import TransverselyIsotropic, stiffness

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Cable:
    """A rod that resists nothing but stretching.

    Across its line it is stiff by its tension alone: without any, straight, and free to move sideways it has no
    stiffness there, and Newton mostly finds no equilibrium. Give it a tension, or hold it across until it has one.

    Attributes:
        line: Nodes at rest, shape (num_nodes, 3), mm.
        radius: Of its tube, mm.
        axial_stiffness: EA, N.
        tension: In the line as it is given, N.
        degree: Of its elements, 1 or 2; one element takes `degree` spans between nodes.
        density: Mass per volume, t/mm^3 (1e-9 of kg/m^3); used by `Rods.run`.
    """

    line: Floats
    radius: float
    axial_stiffness: float
    tension: float = 0.0
    degree: int = 1
    density: float = 0.0

    @property
    def section(self) -> BeamSection:
        """Round, of the radius."""
        return BeamSection.round(self.radius)

    @property
    def constrained_stiffness(self) -> float:
        """EA, N: its section is not deformed."""
        return self.axial_stiffness

    @property
    def stiffness_across(self) -> float:
        """What a first penalty is taken from, N/mm per mm of contact: that of a round bar of this EA."""
        return self.axial_stiffness / self.section.area


@dataclass(frozen=True)
class Beam:
    """A rod that resists stretching, shear, bending, torsion and deformation of its sections.

    Attributes:
        line: Nodes at rest, shape (num_nodes, 3), mm.
        radius: Of its tube, mm.
        material: Moduli, MPa.
        section: Constants of the section; round, of the radius, by default.
        directors: Directors g1, g2 at rest, shape (num_nodes, 2, 3); rotation minimising by default.
        degree: Of its elements, 1 or 2; one element takes `degree` spans between nodes.
        bundle_factor, torsion_factor: On the stiffness in bending and in torsion (the same by default).
        natural_state: "as placed": the line is free of stress; "straight": the rod would be straight if set free.
        tension: In the line as it is given, N.
        density: Mass per volume, t/mm^3 (1e-9 of kg/m^3); used by `Rods.run`.
    """

    line: Floats
    radius: float
    material: YarnMaterial
    section: BeamSection | None = None
    directors: Floats | None = None
    degree: int = 2
    bundle_factor: float = 1.0
    torsion_factor: float | None = None
    natural_state: Literal["as placed", "straight"] = "as placed"
    tension: float = 0.0
    density: float = 0.0

    def __post_init__(self) -> None:
        if self.section is None:
            object.__setattr__(self, "section", BeamSection.round(self.radius))

    @property
    def axial_stiffness(self) -> float:
        """EA, N."""
        assert self.section is not None
        return self.material.axial_modulus * self.section.area

    @property
    def constrained_stiffness(self) -> float:
        """Axial stiffness if the section could not contract, N."""
        assert self.section is not None
        c = stiffness(TransverselyIsotropic(*astuple(self.material)))
        return (
            self.axial_stiffness
            + 2.0 * self.material.axial_poisson**2 * (c.c11 + c.c12) * self.section.area
        )

    @property
    def stiffness_across(self) -> float:
        """What a first penalty is taken from, N/mm per mm of contact."""
        return self.material.transverse_modulus


Rod = Cable | Beam
