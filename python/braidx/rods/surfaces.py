"""What contact sees of rods: cables and beams as tubes, solids as skins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ..bodies import CurveBody, SolidBody
from ..contact.skins import SkinLayout
from ..contact.tubes import TubeLayout, no_tubes
from ..system.terms import Ints
from .rod import Rod, Solid

SURFACES = ("lateral", "start", "end", "inner")  # of a solid, all that bound it


def tubes_of(
    rods: Sequence[Rod],
    bodies: Sequence[CurveBody | SolidBody],
    first_body: Ints,
    groups: Sequence[Sequence[int]],
) -> TubeLayout:
    """Tubes of cables and beams, in their order."""
    parts: list[TubeLayout] = []
    order: list[int] = []
    for body, first, members in zip(bodies, first_body, groups, strict=False):
        if isinstance(body, CurveBody):
            radius = [rods[i].radius for i in members]
            closed = np.array([rods[i].closed for i in members])
            parts.append(replace(body_tubes(body, radius, int(first)), is_closed=closed))
            order += members
    if not parts:
        return no_tubes()
    return _joined(parts, np.array(order))


def skins_of(
    rods: Sequence[Rod],
    bodies: Sequence[CurveBody | SolidBody],
    first_body: Ints,
    place: Ints,
) -> SkinLayout | None:
    """Skins of solids, in their order."""
    facets, radius, offset = [], [], []
    for i, rod in enumerate(rods):
        number, part = int(place[i, 0]), int(place[i, 1])
        body = bodies[number]
        if isinstance(rod, Solid) and isinstance(body, SolidBody):
            nodes = [body.facet_nodes(tag, part) for tag in SURFACES if tag in body.mesh.facets]
            facets.append(first_body[number] + 3 * np.concatenate(nodes))
            radius.append(rod.radius)
            offset.append(np.where(np.arange(len(facets[-1])) < len(nodes[0]), rod.offset, 0.0))
    ones = np.ones(len(facets), dtype=np.int64)
    if not facets:
        return None
    return SkinLayout(tuple(facets), 0 * ones, -ones, np.array(radius, dtype=float), offset=offset)


def body_tubes(body: CurveBody, radius: npt.ArrayLike, first_unknown: int = 0) -> TubeLayout:
    """Tubes around the curves of a body, all of one body as friction sees it.

    Args:
        radius: mm, shape (num_curves,) or one for all.
        first_unknown: Of the body.
    """
    curves, elements = body.curves, body.layout.curve_elements
    ones = np.ones(len(curves) - 1, dtype=np.int64)
    return TubeLayout(
        first_unknown=first_unknown + body.block * curves[:-1],
        num_elements=np.diff(elements),
        degree=body.layout.degree * ones,
        block=body.block * ones,
        radius=np.asarray(radius, dtype=float) * ones,
        element_length=np.add.reduceat(body.rest_lengths(), elements[:-1]) / np.diff(elements),
        body=0 * ones,
    )


def _joined(parts: Sequence[TubeLayout], order: Ints) -> TubeLayout:
    """Tubes of several bodies, each where `order` tells, shape (num_tubes,)."""
    back = np.argsort(order)  # ranks: solids among the rods are passed over
    names = (
        "first_unknown",
        "num_elements",
        "degree",
        "block",
        "radius",
        "element_length",
        "body",
        "is_closed",
    )
    return TubeLayout(
        **{name: np.concatenate([getattr(part, name) for part in parts])[back] for name in names}
    )
