"""What may touch in a bent rope: curves as tubes, solids as skins of the contact engine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...contact.skins import SkinLayout
from ...contact.tubes import TubeLayout
from ...system.constraints import Ints
from .assembly import Assembly
from .contact_bodies import CORE, YARN
from .solids import yarn_offset

NO_YARN = -1  # number of the core among the yarns


@dataclass(frozen=True)
class Surfaces:
    """All surfaces, tubes first.

    Attributes:
        tubes, skins: As the contact engine wants them.
        yarn: Yarn that each surface belongs to, NO_YARN for the core, shape (num_surfaces,).
    """

    tubes: TubeLayout
    skins: SkinLayout | None
    yarn: Ints


def surfaces_of(assembly: Assembly) -> Surfaces:
    """Surfaces of all bodies; two of one yarn never touch."""
    tubes = _tubes(assembly)
    skins, owner = _skins(assembly)
    return Surfaces(tubes, skins, np.concatenate([_tube_yarns(assembly), owner]))


def _tube_yarns(assembly: Assembly) -> Ints:
    yarns = [stretch.yarn for model in ("cable", "beam") for stretch in assembly.of(model)]
    return np.array(yarns + [NO_YARN] * assembly.core_is_beam, dtype=np.int64)


def _tubes(assembly: Assembly) -> TubeLayout:
    yarn = _tube_yarns(assembly)
    scene, is_core = assembly.scene, yarn == NO_YARN
    core_radius = scene.core.radius if scene.core is not None else 0.0
    columns: dict[str, list[np.ndarray]] = {
        name: [] for name in ("first_unknown", "num_elements", "block", "element_length")
    }
    for part in (assembly.cables, assembly.beams):
        if part is None:
            continue
        body, first = part
        layout = body.layout
        count = np.diff(layout.curve_elements)
        columns["first_unknown"].append(first + layout.curves[:-1] * body.block)
        columns["num_elements"].append(count)
        columns["block"].append(np.full(len(count), body.block))
        columns["element_length"].append(body.curve_lengths() / count)
    whole = {
        name: np.concatenate(parts) if parts else np.empty(0, dtype=np.int64)
        for name, parts in columns.items()
    }
    return TubeLayout(
        degree=np.ones(len(yarn), dtype=np.int64),
        radius=np.where(is_core, core_radius, scene.yarn.radius),
        body=np.where(is_core, CORE, YARN),
        group=yarn,
        first_unknown=whole["first_unknown"],
        num_elements=whole["num_elements"],
        block=whole["block"],
        element_length=whole["element_length"],
    )


def _skins(assembly: Assembly) -> tuple[SkinLayout | None, Ints]:
    facets: list[Ints] = []
    owner: list[int] = []
    radius: list[float] = []
    scene = assembly.scene
    if assembly.solids is not None:
        body, first = assembly.solids
        for part, stretch in enumerate(assembly.of("solid")):
            facets.append(first + 3 * body.facet_nodes("lateral", part))
            owner.append(stretch.yarn)
            radius.append(scene.yarn.radius)
    if assembly.core_solid is not None:
        assert scene.core is not None
        body, first = assembly.core_solid
        facets.append(first + 3 * body.facet_nodes(scene.core.surface))
        owner.append(NO_YARN)
        radius.append(scene.core.radius - scene.core.inner_radius)
    numbers = np.array(owner, dtype=np.int64)
    if not facets:
        return None, numbers
    kind = np.where(numbers == NO_YARN, CORE, YARN)
    yarns = numbers != NO_YARN
    return (
        SkinLayout(
            tuple(facets),
            kind,
            numbers,
            np.array(radius),
            # Yarns that touched a smooth core all along would be jammed from the start.
            smooth=yarns,
            offset=np.where(yarns, yarn_offset(scene.yarn), 0.0),
        ),
        numbers,
    )
