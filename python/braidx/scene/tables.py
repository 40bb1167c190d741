"""Tables of a scene, before any check between them."""

from __future__ import annotations

from dataclasses import dataclass, field

from braidx.scene.core import Core
from braidx.scene.ends import EndConditions
from braidx.scene.heat import Heat
from braidx.scene.material import Material, YarnModel
from braidx.scene.numerics import ContactOptions, Expected, OutputOptions, SolverOptions
from braidx.scene.recipe import BraidRecipe, RopeRecipe, StrandRecipe
from braidx.scene.sheave import Sheave
from braidx.scene.step import Step


@dataclass(frozen=True)
class SceneTables:
    """A rope, its model and its programme, as stated."""

    rope: RopeRecipe
    yarn: YarnModel
    strand: StrandRecipe = field(default_factory=StrandRecipe)
    braid: BraidRecipe | None = None
    core: Core | None = None
    sheave: Sheave | None = None
    contact: ContactOptions = field(default_factory=ContactOptions)
    solver: SolverOptions = field(default_factory=SolverOptions)
    ends: EndConditions = field(default_factory=EndConditions)
    output: OutputOptions = field(default_factory=OutputOptions)
    material: dict[str, Material] = field(default_factory=dict)
    heat: Heat | None = None
    steps: tuple[Step, ...] = ()
    expected: dict[str, Expected] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self.rope.name or "scene"

    @property
    def length(self) -> float:
        """Length of the sample, mm."""
        return self.rope.pitch * self.rope.pitches

    @property
    def crown(self) -> float:
        """Where the rope is bent, z of the middle of the sample, mm."""
        return self.length / 2.0
