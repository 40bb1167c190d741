"""Where the sheave is, and how it turns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import braidx_engine as engine
import numpy as np

from ...scene import Bend, Scene
from ...system.constraints import Constraints, Floats, Ints
from .contact_bodies import SHEAVE

AXIS = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True)
class SheavePlace:
    """A sheave below the middle of a straight rope.

    Attributes:
        centre: shape (3,), mm.
        radius: Where the rope lies, mm.
        groove_radius: mm, None for a flat sheave.
    """

    centre: Floats
    radius: float
    groove_radius: float | None

    @staticmethod
    def below(scene: Scene, lines: Sequence[Floats]) -> SheavePlace:
        """A sheave that the straight rope does not touch yet, by the gap that the scene gives."""
        sheave = scene.sheave
        assert sheave is not None
        height, middle = sheave.diameter / 2.0, scene.length / 2.0
        lowest = min(line[:, 1].min() for line in lines) - scene.yarn.radius
        centre = np.array([0.0, lowest - sheave.gap - height, middle])
        return SheavePlace(centre, height, sheave.groove_radius)

    def surface(self, frame: SheaveFrame) -> Any:
        """Engine object of the sheave, turned by a frame."""
        if self.groove_radius is None:
            rigid = engine.make_cylinder(self.centre, AXIS, self.radius, False, SHEAVE)
        else:
            circle = self.radius + self.groove_radius
            rigid = engine.make_sheave(self.centre, AXIS, circle, self.groove_radius, SHEAVE)
        return engine.turned_by(rigid, frame.first_unknown)

    @staticmethod
    def turn(scene: Scene, step: float) -> float:
        """Angle that a driven sheave turns by while the ends move on by a step (mm), radians; 0 of others."""
        sheave = scene.sheave
        assert sheave is not None
        furthest = max(bend.travel for bend in scene.steps if isinstance(bend, Bend))
        return math.radians(sheave.driven_angle) * step / furthest


@dataclass(frozen=True)
class SheaveFrame:
    """What a sheave turns with: its centre x and directors g1 along the axis, g2 and g3 = g1 x g2.

    Attributes:
        first_unknown: Number of its first unknown of twelve.
        centre: shape (3,), mm.
        turns_freely: Whether g2 is free to turn; else its angle is prescribed.
    """

    first_unknown: int
    centre: Floats
    turns_freely: bool

    SIZE: ClassVar[int] = 12

    def vector(self, which: int) -> Ints:
        """Unknowns of x (0), g1 (1), g2 (2) or g3 (3), shape (3,)."""
        return self.first_unknown + 3 * which + np.arange(3)

    @property
    def start(self) -> Floats:
        """Its unknowns before it turns, shape (12,)."""
        return np.concatenate([self.centre, np.eye(3).ravel()])

    def hold(self, constraints: Constraints, values: Floats) -> None:
        """Keeps centre and axis, and lets g3 follow g2: (0, -g2z, g2y) is linear in it."""
        x, g1, g2, g3 = (self.vector(which) for which in range(4))
        held = np.concatenate([x, g1, g2[:1] if self.turns_freely else g2, g3[:1]])
        constraints.hold(held)
        values[held] = self.start[held - self.first_unknown]
        constraints.combine(int(g3[1]), g2[2:], [-1.0])
        constraints.combine(int(g3[2]), g2[1:2], [1.0])

    def turn_to(self, values: Floats, angle: float) -> None:
        """Prescribes the angle that it has turned by since the start, radians, of a sheave that is not free."""
        if not self.turns_freely:
            values[self.vector(2)[1:]] = math.cos(angle), math.sin(angle)

    def turned(self, before: Floats, now: Floats) -> float:
        """Angle from one state of all unknowns to another, less than half a turn, radians."""
        (y, z), (v, w) = before[self.vector(2)[1:]], now[self.vector(2)[1:]]
        return math.atan2(y * w - z * v, y * v + z * w)
