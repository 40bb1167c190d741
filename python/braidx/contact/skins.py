"""Facets of solids as skins of the contact engine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import braidx_engine as engine
import numpy as np
import numpy.typing as npt

from ..system.terms import Floats, Ints


@dataclass(frozen=True)
class SkinLayout:
    """Skins of all solids, one entry per solid; see the engine's Skin.

    Facets have 3, 4, 6 or 9 nodes, all of a skin the same number, in the order of DOLFINx; (dx/du) x (dx/dv) points
    out of the solid.

    Attributes:
        facets: Engine numbers of the first unknown of each facet's nodes, shapes (num_facets, nodes_per_facet).
        body: Number of the body, for friction and for which bodies may touch, shape (num_skins,).
        group: Skins and tubes of one group, from 0, never touch; -1: no group. Shape (num_skins,).
        radius: How deep a particle may be inside before it counts as on the far side of the solid, about half its
            thickness, mm, shape (num_skins,).
        smooth: Whether flat facets stand for the smooth surface through their nodes, shape (num_skins,) or one for all.
        offset: How far the surface is outside the nodes, mm, one number for all, or per skin a number or an array of
            shape (num_facets,): negative where nodes lie outside the surface that they stand for, as those of a
            polygon with the area of a circle.
        dense: Whether facets have more contact points: pressure between facets that do not match gets more even.
    """

    facets: tuple[Ints, ...]
    body: Ints
    group: Ints
    radius: Floats
    smooth: npt.NDArray[np.bool_] | bool = True
    offset: Sequence[Floats | float] | Floats | float = 0.0
    dense: bool = False


def engine_skins(layout: SkinLayout | None, rest: Floats | None) -> list[Any]:
    """Engine objects of skins.

    Args:
        rest: Unknowns of the reference configuration, shape (num_unknowns,), which contact areas and sharp edges
            are those of.

    Raises:
        ValueError: No rest positions, or facets that are none.
    """
    if layout is None:
        return []
    if rest is None:
        raise ValueError("rest is None: skins need the unknowns at rest, which their areas are of")
    return [
        _engine_skin(number, layout, np.ascontiguousarray(rest, dtype=float))
        for number in range(len(layout.facets))
    ]


def _engine_skin(number: int, layout: SkinLayout, rest: Floats) -> Any:
    facets = np.ascontiguousarray(layout.facets[number], dtype=np.int64)
    if facets.ndim != 2 or facets.shape[1] not in (3, 4, 6, 9):
        raise ValueError(
            f"facets of skin {number} have shape {facets.shape}: give (num_facets, 3, 4, 6 or 9)"
        )
    if facets.size and not 0 <= facets.min() <= facets.max() <= len(rest) - 3:
        raise ValueError(
            f"facets of skin {number} name unknowns {facets.min()} to {facets.max()}: "
            f"rest has {len(rest)}, give numbers of the first of three"
        )
    offset = layout.offset if isinstance(layout.offset, float) else layout.offset[number]
    return engine.make_skin(
        facets,
        int(layout.body[number]),
        float(layout.radius[number]),
        int(layout.group[number]),
        rest,
        layout.dense,
        np.broadcast_to(layout.smooth, len(layout.facets))[number].item(),
        np.ascontiguousarray(np.broadcast_to(offset, len(facets)), dtype=float),
    )
