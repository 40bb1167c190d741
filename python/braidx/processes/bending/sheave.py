"""Where the sheave is, and how it turns."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import braidx_engine as engine
import numpy as np

from ...scene import Bend, Scene
from ...system.constraints import Floats
from .surfaces import SHEAVE

AXIS = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True)
class SheavePlace:
    """A sheave below the middle of a straight rope.

    Attributes:
        centre: shape (3,), mm.
        radius: Where the rope lies, mm.
        groove_radius: mm, None for a flat sheave.
        turns_freely: Whether it turns as friction takes it along.
    """

    centre: Floats
    radius: float
    groove_radius: float | None
    turns_freely: bool

    @staticmethod
    def below(scene: Scene, lines: Sequence[Floats]) -> SheavePlace:
        """A sheave that the straight rope does not touch yet, by the gap that the scene gives."""
        sheave = scene.sheave
        assert sheave is not None
        height, middle = sheave.diameter / 2.0, scene.length / 2.0
        lowest = min(line[:, 1].min() for line in lines) - scene.yarn.radius
        centre = np.array([0.0, lowest - sheave.gap - height, middle])
        return SheavePlace(centre, height, sheave.groove_radius, sheave.motion == "free")

    def surface(self, turned: float = 0.0) -> Any:
        """Engine object of the sheave, which turns by an angle (radians) in the increment."""
        if self.groove_radius is None:
            rigid = engine.make_cylinder(self.centre, AXIS, self.radius, False, SHEAVE)
        else:
            circle = self.radius + self.groove_radius
            rigid = engine.make_sheave(self.centre, AXIS, circle, self.groove_radius, SHEAVE)
        if math.isclose(turned, 0.0):
            return rigid
        return engine.moved(rigid, self.centre, turned * AXIS, np.zeros(3))

    @staticmethod
    def turn(scene: Scene, step: float) -> float:
        """Angle that a driven sheave turns by while the ends move on by a step (mm), radians."""
        sheave = scene.sheave
        assert sheave is not None
        furthest = max(bend.travel for bend in scene.steps if isinstance(bend, Bend))
        return math.radians(sheave.driven_angle) * step / furthest
