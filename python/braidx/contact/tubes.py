"""Curves of bodies as tubes of the contact engine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import braidx_engine as engine
import numpy as np
import numpy.typing as npt

from ..system.terms import Floats, Ints
from .beyond import Beyond


@dataclass(frozen=True)
class TubeLayout:
    """Tubes of all bodies, one entry per curve; see the engine's Tube.

    Attributes:
        first_unknown: Engine number of the first unknown, shape (num_tubes,).
        num_elements, degree, block: shape (num_tubes,).
        radius, element_length: mm, shape (num_tubes,).
        body: Number of the body, for friction per pair of bodies, shape (num_tubes,).
        beyond: Elements that tubes go on for past either end, as they do at the other end (periodic samples).
        group: Tubes and skins of one group, from 0, never touch, a tube itself excepted; -1: no group. Shape
            (num_tubes,); None: no groups.
        is_closed: Whether a tube is a ring, whose last node is its first one, shape (num_tubes,); None: nowhere.
        round_ends: Whether ends of tubes touch, as half spheres of their radius.
        is_image: Whether the equilibrium of a tube repeats another's by symmetry, shape (num_tubes,); None: nowhere.
    """

    first_unknown: Ints
    num_elements: Ints
    degree: Ints
    block: Ints
    radius: Floats
    element_length: Floats
    body: Ints
    beyond: int = 0
    is_image: npt.NDArray[np.bool_] | None = None
    group: Ints | None = None
    is_closed: npt.NDArray[np.bool_] | None = None
    round_ends: bool = False


def no_tubes() -> TubeLayout:
    """Of scenes without cables and beams."""
    none, nothing = np.empty(0, np.int64), np.empty(0)
    return TubeLayout(none, none, none, none, nothing, nothing, none)


def nodes_beyond(layout: TubeLayout) -> Beyond | None:
    """What contact sees past the ends of tubes of a periodic sample."""
    if not layout.beyond:
        return None
    degree = int(layout.degree[0])
    num_nodes = layout.num_elements * degree + 1
    return Beyond.of(layout.first_unknown, num_nodes, layout.block, layout.beyond * degree)


def engine_tubes(layout: TubeLayout, smooth: bool, beyond: Beyond | None = None) -> Any:
    """Engine object of tubes; smooth: contact geometry without the kinks of finite elements of degree 1."""
    int32 = {
        name: getattr(layout, name).astype(np.int32)
        for name in ("num_elements", "degree", "block", "body")
    }
    is_image = np.zeros(len(layout.radius), bool) if layout.is_image is None else layout.is_image
    first = beyond.first_unknown if beyond else layout.first_unknown
    return engine.make_tubes(
        first_unknown=first.astype(np.int64),
        radius=layout.radius.astype(float),
        element_length=layout.element_length.astype(float),
        is_image=is_image,
        smooth=smooth,
        beyond=layout.beyond,
        group=_listed(layout.group),
        closed=_listed(layout.is_closed),
        round_ends=layout.round_ends,
        **int32,
    )


def _listed(values: npt.NDArray[Any] | None) -> list[int]:
    return [] if values is None else [int(value) for value in values]


def no_crossings() -> Any:
    """Engine object for scenes without prescribed stacking order."""
    nothing = np.empty(0, np.int32)
    return engine.make_crossings(
        tubes=nothing.reshape(0, 2),
        windows=np.empty((0, 4)),
        order=nothing,
        axis=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
    )
