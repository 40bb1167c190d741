"""What yarns are made of and how they are modelled."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.errors import SceneError, nearest
from braidx.scene.fields import Table, option

MODELS = ("cable", "beam", "solid", "mixed", "auto")


@dataclass(frozen=True)
class Material(Table):
    """A named material, [material.NAME]: values for the yarns that name it, whatever these are modelled as."""

    table: ClassVar[str] = "material"

    axial_modulus: float | None = option(
        None, unit="MPa", above=0.0, doc="Modulus along the yarn; gives axial_stiffness = E A."
    )
    transverse_modulus: float | None = option(
        None, unit="MPa", above=0.0, doc="Modulus across the yarn."
    )
    shear_modulus: float | None = option(
        None, unit="MPa", above=0.0, doc="Shear modulus between the axis and the section."
    )
    poisson_axial: float | None = option(
        None, minimum=0.0, maximum=1.0, doc="Contraction across for a stretch along the yarn."
    )
    poisson_transverse: float | None = option(
        None, above=-1.0, below=1.0, doc="Poisson ratio within the section."
    )
    bundle_factor: float | None = option(
        None,
        above=0.0,
        maximum=1.0,
        doc="Factor on the bending stiffness of a bundle of filaments, as that of [yarn].",
    )
    torsion_factor: float | None = option(
        None, above=0.0, maximum=1.0, doc="Factor on its torsional stiffness."
    )


@dataclass(frozen=True)
class YarnModel(Table):
    """One yarn: a bundle of filaments, as a cable, as a beam or as a solid."""

    table: ClassVar[str] = "yarn"

    radius: float = option(unit="mm", above=0.0, doc="Radius of the yarn's round section.")
    model: str = option(
        "cable",
        choices=MODELS,
        needs="own model",
        doc="Cable: tension only, 3 unknowns per node. Beam: also bending, torsion and deformation "
        "of the section, 9 unknowns per node (paper 1, eq. 1). Ropes that are bent also have solid: "
        "hexahedra (paper 2); mixed: hexahedra in solid_stretch and outer_model beyond; auto: the "
        "simplest of these that each yarn's place asks for.",
    )
    axial_stiffness: float = option(
        162e3, unit="N", above=0.0, doc="Axial stiffness EA of the yarn."
    )
    bundle_factor: float = option(
        1e-3,
        above=0.0,
        maximum=1.0,
        doc="Factor on the bending stiffness, about 1 / number of filaments (paper 1, 5.1).",
        needs="sections or bent",
    )
    torsion_factor: float | None = option(
        None,
        above=0.0,
        maximum=1.0,
        doc="Factor on the torsional stiffness; left out: bundle_factor.",
        needs="beams",
    )
    transverse_modulus: float = option(
        2000.0, unit="MPa", above=0.0, doc="Modulus across the yarn.", needs="sections or bent"
    )
    shear_modulus: float = option(
        1000.0,
        unit="MPa",
        above=0.0,
        doc="Shear modulus between the axis and the section.",
        needs="sections",
    )
    poisson_axial: float = option(
        0.3,
        minimum=0.0,
        maximum=1.0,
        doc="Contraction across for a stretch along the yarn.",
        needs="sections",
    )
    poisson_transverse: float = option(
        0.3, above=-1.0, below=1.0, doc="Poisson ratio within the section.", needs="sections"
    )
    area: float | None = option(
        None, unit="mm^2", above=0.0, doc="Area of the section; left out: that of the circle."
    )
    inertia_1: float | None = option(
        None,
        unit="mm^4",
        above=0.0,
        doc="Second moment of area along g1; left out: the circle's.",
        needs="beams",
    )
    inertia_2: float | None = option(
        None,
        unit="mm^4",
        above=0.0,
        doc="Second moment of area along g2; left out: the circle's.",
        needs="beams",
    )
    torsion_constant: float | None = option(
        None,
        unit="mm^4",
        above=0.0,
        doc="Torsion constant J; left out: inertia_1 + inertia_2.",
        needs="beams",
    )
    natural_state: str = option(
        "as placed",
        choices=("as placed", "straight"),
        doc="Shape in which a beam is free of bending and torsion.",
        needs="placed beams",
    )
    axial_law: str = option(
        "Saint-Venant-Kirchhoff",
        choices=("Saint-Venant-Kirchhoff", "linear"),
        doc="Force along the fibres of beams: linear in their Green-Lagrange strain, as in solids, or in their "
        "stretch, as in cables; 1.5 % apart at 1 % strain. It is that of a core of beams too.",
    )
    # left out only until the scene is made, see defaults.py
    degree: int = option(
        None,
        choices=(1, 2),
        doc="Degree of the finite elements; left out: 2 of cables, but not in braids of strands of several yarns, and "
        "not where elements_per_pitch is stated; otherwise 1.",
    )
    elements_per_pitch: int = option(
        None,
        minimum=4,
        doc="Finite elements of a yarn per rope.pitch; left out: 40 of degree 1, or three of degree 2 from crossing to "
        "crossing (24 at least), but for nodes closer than two thirds of the radius.",
    )
    material: str = option("", doc="Name of a [material.NAME] table whose values are taken over.")
    seeds: int = option(
        12,
        minimum=4,
        maximum=400,
        doc="Edges of elements round a solid yarn, a multiple of 4 (12 in paper 2).",
        needs="solids",
    )
    solid_degree: int = option(
        1, choices=(1, 2), doc="Degree of the elements of a solid yarn.", needs="solids"
    )
    solid_elements_per_pitch: int | None = option(
        None,
        minimum=4,
        doc="Elements of a solid yarn along rope.pitch; left out: elements_per_pitch.",
        needs="solids",
    )
    solid_stretch: float | None = option(
        None,
        unit="mm",
        above=0.0,
        doc="Length along the axis, half on either side of the sample's middle, in which a mixed yarn is solid.",
        needs="mixed",
    )
    outer_model: str = option(
        "beam",
        choices=("beam", "cable"),
        doc="Model of a mixed yarn beyond solid_stretch.",
        needs="mixed",
    )
    models: dict[str, str] = option(
        {},
        doc='Yarns with a model of their own, by number from 0 in the order of the recipe: { 3 = "solid" }.',
        needs="bent",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        self._check_solid()
        self._check_axial_law()
        axial_modulus = self.axial_stiffness / self.section_area
        ratio = self.transverse_modulus / axial_modulus
        if 1.0 - self.poisson_transverse - 2.0 * self.poisson_axial**2 * ratio <= 0.0:
            raise SceneError(
                "yarn.poisson_axial",
                "no stable material with these moduli: 1 - poisson_transverse - 2 poisson_axial^2 "
                "E_transverse / E_axial must be positive; lower a Poisson ratio or the transverse "
                "modulus.",
                self.poisson_axial,
            )

    def _check_solid(self) -> None:
        if self.seeds % 4:
            near = max(4, 4 * round(self.seeds / 4))
            raise SceneError("yarn.seeds", f"not a multiple of 4, use {near}.", self.seeds)
        for number, model in self.models.items():
            if not re.fullmatch("0|[1-9][0-9]{0,8}", number):
                cure = 'not the number of a yarn; write whole numbers from 0, such as 3 = "beam".'
                raise SceneError(f"yarn.models.{number}", cure, model)
            if model not in MODELS:
                cure = f"choose {' or '.join(MODELS)}; {nearest(model, MODELS)}"
                raise SceneError(f"yarn.models.{number}", cure, model)

    def _check_axial_law(self) -> None:
        models = {self.model, *self.models.values()}
        beams = models & {"beam", "auto"} or ("mixed" in models and self.outer_model == "beam")
        if self.axial_law == "linear" and not beams:
            cure = 'no yarn is a beam; leave it out, or use yarn.model = "beam".'
            raise SceneError("yarn.axial_law", cure, self.axial_law)

    def model_of(self, number: int) -> str:
        """Model of a yarn, by its number."""
        return self.models.get(str(number), self.model)

    @property
    def section_area(self) -> float:
        """Area of the section, mm^2."""
        return 3.141592653589793 * self.radius**2 if self.area is None else self.area
