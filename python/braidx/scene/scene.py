"""A scene: everything a run needs, as one frozen value equal to a TOML file."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

from braidx.scene.defaults import with_depth, with_mesh
from braidx.scene.effects import check_effects
from braidx.scene.errors import SceneError
from braidx.scene.fields import Spec, convert, type_hints
from braidx.scene.pitch import resolved_pitch
from braidx.scene.results import check_expected
from braidx.scene.rules import check_bending
from braidx.scene.size import check_size
from braidx.scene.tables import SceneTables

TABLE = Spec(doc="")  # what it takes is in its type


@dataclass(frozen=True)
class Scene(SceneTables):
    """A rope, its model and its programme. Of a scene, rope.pitch is known, and agrees with the braid's angle; so is
    what depends on other keys (defaults.py).

    Raises:
        SceneError: If the rope's type and its tables do not go together.
    """

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
