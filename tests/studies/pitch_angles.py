"""How the stiffness of ropes of several pitches goes with the angle of their strands."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from pulled_values import STIFFNESS, Line, state_of, straight_line
from rope_shape import helix_angle, efficiency_of_directions, strand_radius
from study_page import column
from study_runs import Outcome


@dataclass(frozen=True)
class Angles:
    """Of the strands, and what the stiffness makes of it; one entry per rope."""

    radius: list[float]  # mm, of the strands' helices
    angle: list[float]  # radians
    square: list[float]  # cos^2 of it
    yarns: list[float]  # efficiency that the yarns' own directions leave
    line: Line  # stiffness (kN) over `square`
    exponent: float  # of `square` that the stiffness goes with


def angles(outcomes: Sequence[Outcome]) -> Angles:
    """Of the formed ropes."""
    formed = [state_of(outcome.folder, "formed") for outcome in outcomes]
    radius = [strand_radius(state) for state in formed]
    angle = [helix_angle(r, o.case.value) for r, o in zip(radius, outcomes, strict=True)]
    square = [math.cos(a) ** 2 for a in angle]
    stiffness = column(outcomes, STIFFNESS)
    power = straight_line(np.log(square), np.log(stiffness)).slope
    yarns = [efficiency_of_directions(state) for state in formed]
    return Angles(radius, angle, square, yarns, straight_line(square, stiffness), power)
