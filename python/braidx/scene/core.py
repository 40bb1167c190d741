"""The core that fills a braid: a cylinder along the axis, or a mesh of one's own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.errors import SceneError
from braidx.scene.fields import Table, option


@dataclass(frozen=True)
class Core(Table):
    """What fills the braid: a cylinder about the axis, solid or hollow, as long as the sample (paper 2)."""

    table: ClassVar[str] = "core"

    radius: float = option(unit="mm", above=0.0, doc="Outer radius.")
    inner_radius: float = option(
        0.0, unit="mm", minimum=0.0, doc="Radius of its bore; 0: none.", needs="solid core"
    )
    model: str = option(
        "solid",
        choices=("solid", "beam", "rigid"),
        doc="Solid: finite elements in three dimensions. Beam: one yarn along the axis, whose section deforms "
        "uniformly. Rigid: a cylinder that neither bends nor moves, and, once the rope is formed, has no friction.",
    )
    law: str = option(
        "st-venant-kirchhoff",
        choices=("st-venant-kirchhoff", "neo-hooke"),
        doc="Law of its isotropic material; neo-hooke where it is compressed strongly.",
        needs="solid core",
    )
    modulus: float = option(200.0, unit="MPa", above=0.0, doc="Young's modulus.", needs="soft core")
    poisson: float = option(0.3, above=-1.0, below=0.5, doc="Poisson ratio.", needs="soft core")
    degree: int = option(
        1, choices=(1, 2), doc="Degree of its finite elements.", needs="swept core"
    )
    seeds: int = option(
        12,
        minimum=4,
        maximum=400,
        doc="Edges of elements round it; an o-grid wants a multiple of 4.",
        needs="swept core",
    )
    section: str = option(
        "o-grid",
        choices=("o-grid", "wedge"),
        doc="How its section is divided: quadrilaterals about a square, or triangles about the centre and "
        "quadrilaterals round them.",
        needs="swept core",
    )
    element_length: float | None = option(
        None,
        unit="mm",
        above=0.0,
        doc="Length of its elements along the axis; left out: that of the yarns' elements.",
        needs="swept core",
    )
    mesh: str = option(
        "",
        doc="Mesh that takes the place of the cylinder: a .geo or .msh file of gmsh, or what meshio reads, placed as "
        "the rope is, its axis on z from 0. A path is that from the scene's folder.",
        needs="solid core",
    )
    surface: str = option(
        "lateral",
        doc="Tag of the surface that may touch; a mesh of one's own names it.",
        needs="meshed core",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.inner_radius >= self.radius:
            cure = f"must be below core.radius = {self.radius:g} mm; 0 for a core without a bore."
            raise SceneError("core.inner_radius", cure, self.inner_radius)
        if self.section == "o-grid" and self.seeds % 4:
            near = max(4, 4 * round(self.seeds / 4))
            raise SceneError("core.seeds", f"not a multiple of 4, use {near}.", self.seeds)
        if self.inner_radius > 0.0 and self.model == "beam":
            cure = 'a beam has no bore; use 0, or core.model = "solid".'
            raise SceneError("core.inner_radius", cure, self.inner_radius)
        if self.mesh and self.model != "solid":
            cure = (
                f'only a solid has a mesh, core.model is "{self.model}"; leave one of the two out.'
            )
            raise SceneError("core.mesh", cure, self.mesh)
