"""A scene: everything a run needs, as one frozen value equal to a TOML file."""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace

from braidx.scene.core import Core
from braidx.scene.defaults import with_depth, with_mesh
from braidx.scene.effects import check_effects
from braidx.scene.ends import EndConditions
from braidx.scene.errors import SceneError
from braidx.scene.fields import Spec, convert, type_hints
from braidx.scene.heat import Heat
from braidx.scene.material import Material, YarnModel
from braidx.scene.numerics import (
    ContactOptions,
    Expected,
    OutputOptions,
    SolverOptions,
)
from braidx.scene.pitch import resolved_pitch
from braidx.scene.recipe import BraidRecipe, RopeRecipe, StrandRecipe
from braidx.scene.results import check_expected
from braidx.scene.rules import check_bending
from braidx.scene.sheave import Sheave
from braidx.scene.size import check_size
from braidx.scene.step import Step

TABLE = Spec(doc="")  # what it takes is in its type


@dataclass(frozen=True)
class Scene:
    """A rope, its model and its programme. Of a scene, rope.pitch is known, and agrees with the braid's angle; so is
    what depends on other keys (defaults.py).

    Raises:
        SceneError: If the rope's type and its tables do not go together.
    """

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

    def __post_init__(self) -> None:
        for each in fields(self):
            table = convert(
                getattr(self, each.name), type_hints(Scene)[each.name], TABLE, each.name
            )
            object.__setattr__(self, each.name, table)
        pitch = resolved_pitch(self.rope, self.braid)
        self._check_type()
        object.__setattr__(self, "rope", replace(self.rope, pitch=pitch))
        object.__setattr__(self, "yarn", with_mesh(self))
        object.__setattr__(self, "contact", with_depth(self))
        check_size(self)
        check_bending(self)
        check_effects(self)
        check_expected(self.expected)

    def _check_type(self) -> None:
        if self.rope.type == "braid" and self.braid is None:
            raise SceneError(
                "braid", 'table missing: a braid needs it; rope.type = "strand" does without.'
            )
        if self.rope.type == "strand" and self.braid is not None:
            raise SceneError(
                "rope.type",
                'a strand has no [braid]: remove that table or write "braid".',
                "strand",
            )

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
