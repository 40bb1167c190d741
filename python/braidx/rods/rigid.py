"""Rigid surfaces that rods may touch, with numbers of their own for friction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import braidx_engine as engine
import numpy as np
import numpy.typing as npt

from .given import numbers


@dataclass(frozen=True)
class Plane:
    """All that is below a plane.

    Attributes:
        point: On it, shape (3,), mm.
        normal: To where rods are, shape (3,).
    """

    point: npt.ArrayLike
    normal: npt.ArrayLike

    def surface(self, body: int) -> Any:
        """Engine object with a number of the body."""
        return engine.make_plane(numbers("point", self.point, 3), _way("normal", self.normal), body)


@dataclass(frozen=True)
class Cylinder:
    """A cylinder without ends; hollow: rods are within it.

    Attributes:
        point: On its axis, shape (3,), mm.
        axis: Shape (3,).
        radius: mm.
    """

    point: npt.ArrayLike
    axis: npt.ArrayLike
    radius: float
    hollow: bool = False

    def surface(self, body: int) -> Any:
        """Engine object with a number of the body."""
        point, axis = numbers("point", self.point, 3), _way("axis", self.axis)
        return engine.make_cylinder(point, axis, self.radius, self.hollow, body)


@dataclass(frozen=True)
class Sheave:
    """A sheave with a round groove.

    Attributes:
        centre: Shape (3,), mm.
        axis: Shape (3,).
        radius: At the bottom of the groove, mm.
        groove_radius: Of the groove's section, mm.
    """

    centre: npt.ArrayLike
    axis: npt.ArrayLike
    radius: float
    groove_radius: float

    def surface(self, body: int) -> Any:
        """Engine object with a number of the body."""
        centre, axis = numbers("centre", self.centre, 3), _way("axis", self.axis)
        return engine.make_sheave(centre, axis, self.radius, self.groove_radius, body)


FIRST_BODY = 1  # of rods; rigid surfaces come after them, and objects of the engine are body 0
RigidSurface = Plane | Cylinder | Sheave


def make_rigid(surfaces: Sequence[RigidSurface | Any], num_rods: int) -> list[Any]:
    """Engine objects of rigid surfaces, whose bodies are numbered after the rods; engine objects stay as they are."""
    return [
        (
            surface.surface(FIRST_BODY + num_rods + number)
            if isinstance(surface, RigidSurface)
            else surface
        )
        for number, surface in enumerate(surfaces)
    ]


def _way(name: str, value: npt.ArrayLike) -> npt.NDArray[np.float64]:
    way = numbers(name, value, 3)
    if not way.any():
        raise ValueError(f"{name} is {way}: give a direction")
    return way
