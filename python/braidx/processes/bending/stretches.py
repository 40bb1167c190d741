"""Which stretch of which yarn is modelled as what."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ...scene import Scene
from ...system.constraints import Floats, Ints
from .cheapest import cheapest_model

MODELS = ("cable", "beam", "solid")


@dataclass(frozen=True)
class Stretch:
    """Nodes `first` to `last`, both included, of the centre line of a yarn, and the model of what lies between them."""

    yarn: int
    model: str
    first: int
    last: int

    @property
    def nodes(self) -> slice:
        """Its nodes among those of the yarn."""
        return slice(self.first, self.last + 1)


def stretches_of(scene: Scene, lines: Sequence[Floats]) -> tuple[Stretch, ...]:
    """All stretches as the scene asks for them, yarn by yarn, along each yarn.

    "auto" starts from the cheapest model; what needs more is found out later.

    Args:
        scene: The scene.
        lines: Centre lines of the straight rope, shape (num_nodes, 3) each, mm.
    """
    yarn, middle = scene.yarn, scene.length / 2.0
    models = [yarn.model_of(number) for number in range(len(lines))]
    cheapest = cheapest_model(scene) if "auto" in models else ""
    out: list[Stretch] = []
    for number, (line, model) in enumerate(zip(lines, models, strict=True)):
        is_solid: npt.NDArray[np.bool_] = np.zeros(len(line), dtype=bool)
        outer = cheapest if model == "auto" else model
        if model == "mixed":
            assert yarn.solid_stretch is not None  # the scene has been checked
            is_solid = np.abs(line[:, 2] - middle) <= yarn.solid_stretch / 2.0
            outer = yarn.outer_model
        out += with_solid(number, outer, is_solid)
    return tuple(out)


def with_solid(yarn: int, outer: str, is_solid: npt.NDArray[np.bool_]) -> list[Stretch]:
    """Stretches of one yarn of model `outer` but for the elements both nodes of which are solid."""
    solid = is_solid[:-1] & is_solid[1:]
    cuts = np.flatnonzero(np.diff(solid)) + 1
    bounds = [0, *map(int, cuts), len(solid)]
    return [
        Stretch(yarn, "solid" if solid[first] else outer, first, last)
        for first, last in zip(bounds[:-1], bounds[1:], strict=True)
    ]


def as_table(stretches: Sequence[Stretch]) -> Ints:
    """Stretches as numbers: yarn, model, first and last node, shape (num_stretches, 4)."""
    return np.array(
        [(s.yarn, MODELS.index(s.model), s.first, s.last) for s in stretches], dtype=np.int64
    ).reshape(-1, 4)


def from_table(table: Ints) -> tuple[Stretch, ...]:
    """Stretches from `as_table`."""
    return tuple(
        Stretch(int(yarn), MODELS[model], int(first), int(last))
        for yarn, model, first, last in table
    )
