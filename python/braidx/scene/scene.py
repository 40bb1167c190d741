"""A scene: everything a run needs, as one frozen value equal to a TOML file."""

from __future__ import annotations

from dataclasses import dataclass, field

from braidx.scene.ends import EndConditions
from braidx.scene.errors import SceneError
from braidx.scene.material import Material, YarnModel
from braidx.scene.numerics import (
    ContactOptions,
    Expected,
    OutputOptions,
    SolverOptions,
)
from braidx.scene.recipe import BraidRecipe, RopeRecipe, StrandRecipe
from braidx.scene.steps import Step


@dataclass(frozen=True)
class Scene:
    """A rope, its model and its programme.

    Raises:
        SceneError: If the rope's type and its tables do not go together.
    """

    rope: RopeRecipe
    yarn: YarnModel
    strand: StrandRecipe = field(default_factory=StrandRecipe)
    braid: BraidRecipe | None = None
    contact: ContactOptions = field(default_factory=ContactOptions)
    solver: SolverOptions = field(default_factory=SolverOptions)
    ends: EndConditions = field(default_factory=EndConditions)
    output: OutputOptions = field(default_factory=OutputOptions)
    material: dict[str, Material] = field(default_factory=dict)
    steps: tuple[Step, ...] = ()
    expected: dict[str, Expected] = field(default_factory=dict)

    def __post_init__(self) -> None:
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
