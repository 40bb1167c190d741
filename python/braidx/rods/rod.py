"""What a rod is: its centre line at rest, its section and what it is made of."""

from __future__ import annotations

from dataclasses import astuple, dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from ..bodies import BeamSection, YarnMaterial
from ..bodies.solid import Law
from ..forms.beam import AxialLaw
from ..forms.materials import TransverselyIsotropic, stiffness
from ..meshing import SectionMesh, round_section

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Cable:
    """A rod that resists nothing but stretching.

    Across its line it is stiff by its tension alone. Placed without any it can be pulled taut, or loaded across, which
    makes it sag. Where it is slack it carries no force, and where nothing touches or holds it, it has no shape.

    Attributes:
        line: Nodes at rest, shape (num_nodes, 3), mm.
        radius: Of its tube, mm.
        axial_stiffness: EA, N.
        tension: In the line as it is given, N.
        degree: Of its elements, 1 or 2; one element takes `degree` spans between nodes.
        closed: Whether it is a ring: the line ends at its first node, once more, and its sections there are one.
        density: Mass per volume, t/mm^3 (1e-9 of kg/m^3); used by `Rods.run`.
    """

    line: Floats
    radius: float
    axial_stiffness: float
    tension: float = 0.0
    degree: int = 2
    density: float = 0.0
    closed: bool = False

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
        closed: Whether it is a ring: the line ends at its first node, once more, and its sections there are one.
        density: Mass per volume, t/mm^3 (1e-9 of kg/m^3); used by `Rods.run`.
        axial_law: Of the force along fibres: linear in their Green-Lagrange strain ("Saint-Venant-Kirchhoff", as in
            solids; 1.5 % off Hooke's law at 1 % strain), or in their stretch ("linear").
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
    axial_law: AxialLaw = "Saint-Venant-Kirchhoff"
    closed: bool = False

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
        return _constrained_modulus(self.material) * self.section.area

    @property
    def stiffness_across(self) -> float:
        """What a first penalty is taken from, N/mm per mm of contact."""
        return self.material.transverse_modulus


@dataclass(frozen=True)
class Solid:
    """A rod of hexahedra, swept along its line: it resists every deformation, within its sections, too.

    Its sections are held, moved and loaded like those of a beam. The first and the last one stay plane, and stretch and
    shear as a beam's do; of those between, position and directors are the mean and the mean slopes of their nodes.

    Attributes:
        line: Centres of sections at rest, shape (num_nodes, 3), mm.
        radius: Of the round section, mm; of any other, about half of its thickness.
        material: Moduli, MPa.
        section: Mesh of the section, about its centroid and main axes; round, with the area of the circle, by default.
        directors: Directors g1, g2 at rest, shape (num_nodes, 2, 3); rotation minimising by default.
        degree: Of the hexahedra, 1 or 2, which take as many spans between sections; that of `section`, if given. With 1
            they cost a tenth, but are polygons where they touch: forces differ by a fifth with 8 seeds.
        seeds: Edges round the section by default, a multiple of four.
        law: See SolidBody.
        tension: In the line as it is given, N; of the transversely isotropic law only.
        closed: False: rings are cables or beams.
        density: Mass per volume, t/mm^3 (1e-9 of kg/m^3); used by `Rods.run`.
    """

    line: Floats
    radius: float
    material: YarnMaterial
    section: SectionMesh | None = None
    directors: Floats | None = None
    degree: int = 2
    seeds: int = 8
    law: Law = "transversely isotropic"
    tension: float = 0.0
    density: float = 0.0
    closed: bool = False

    def __post_init__(self) -> None:
        if self.closed:
            raise ValueError(
                "closed = True: a Solid has two ends, give a Beam or a Cable for a ring"
            )
        if self.section is None:
            section = round_section(self.radius, self.seeds, degree=self.degree, equal_area=True)
            object.__setattr__(self, "section", section)
        else:
            object.__setattr__(self, "degree", self.section.degree)

    @property
    def area(self) -> float:
        """Of the section's mesh, mm^2."""
        assert self.section is not None
        return float(self.section.weights().sum())

    @property
    def offset(self) -> float:
        """How far the surface is outside the outer nodes, mm (negative where polygons stand for a circle)."""
        assert self.section is not None
        return min(0.0, self.radius - self.section.outer_radius) if self.section.is_round else 0.0

    @property
    def constrained_stiffness(self) -> float:
        """Axial stiffness if the section could not contract, N."""
        return _constrained_modulus(self.material) * self.area

    @property
    def stiffness_across(self) -> float:
        """What a first penalty is taken from, N/mm per mm of contact."""
        return self.material.transverse_modulus


Rod = Cable | Beam | Solid


def _constrained_modulus(material: YarnMaterial) -> float:
    """Axial modulus of a rod that may not contract, MPa."""
    c = stiffness(TransverselyIsotropic(*astuple(material)))
    return float(material.axial_modulus + 2.0 * material.axial_poisson**2 * (c.c11 + c.c12))
