"""Centre lines of strands, and of yarns about them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.undulation import Undulation

Array = NDArray[np.float64]
MOST_TURN = np.pi / 2.0  # between nodes: parabolas through three of a half circle are 13 % nearer


@dataclass(frozen=True)
class StrandHelix:
    """Centre line of a strand: a helix around z; with radius 0 and infinite pitch the axis."""

    radius: float  # mean, mm
    pitch: float  # mm
    sense: int  # +1 right-handed, -1 left-handed
    phase: float  # radians
    undulation: Undulation | None = None

    def point(self, z: Array) -> Array:
        """Points of the centre line at these z, shape (n, 3)."""
        angle, radius = self._angle(z), self._radius(z)
        return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])

    def frame(self, z: Array) -> tuple[Array, Array]:
        """Unit vectors n and t x n, t being the unit tangent and n the outward one next to the radial; (n, 3) each."""
        angle, zero = self._angle(z), np.zeros_like(z)
        round_, out = self.sense * 2.0 * np.pi * self._radius(z) / self.pitch, self._slope(z)
        length = np.hypot(round_, 1.0)
        sine, cosine = round_ / length, 1.0 / length
        radial = np.column_stack([np.cos(angle), np.sin(angle), zero])
        across = np.column_stack([-np.sin(angle) * cosine, np.cos(angle) * cosine, zero - sine])
        if self.undulation is None:
            return radial, across
        along = np.column_stack([-np.sin(angle) * sine, np.cos(angle) * sine, cosine])
        tilt = np.arctan2(out, length)[
            :, None
        ]  # the strand's way out, against the surface of the mean helix
        return np.cos(tilt) * radial - np.sin(tilt) * along, across

    def _angle(self, z: Array) -> Array:
        return self.phase + self.sense * 2.0 * np.pi * z / self.pitch

    def _radius(self, z: Array) -> Array | float:
        return self.radius if self.undulation is None else self.radius + self.undulation.offset(z)

    def _slope(self, z: Array) -> Array | float:
        return 0.0 if self.undulation is None else self.undulation.slope(z)


def outside(radius: float, turn: float) -> float:
    """Radius on which nodes of a helix lie so that no curve between them comes nearer to the axis than `radius`, mm.

    With c = 1 - cos(turn), a parabola through three nodes on a radius r comes as near as r sqrt(1 - c^2 / 4). That is
    an element of degree 2, and the end of a line of degree 1; between, its contact geometry stays farther out.

    Args:
        radius: mm.
        turn: Angle between nodes next to each other, radians, at most MOST_TURN in size.
    """
    return float(radius / np.sqrt(1.0 - 0.25 * (1.0 - np.cos(turn)) ** 2))


def place_yarn(helix: StrandHelix, radius: float, phase: float, rate: float, z: Array) -> Array:
    """Centre line of a yarn with its nodes exactly at the given z, shape (n, 3), mm.

    The yarn lies in the plane normal to the strand at the strand's height s, at the angle
    phase + rate s from the outward vector; s is solved for with Newton's method.

    Args:
        helix: Centre line of the strand.
        radius: Distance from it, mm.
        phase: Angle at s = 0, radians.
        rate: Turns, radians per mm of s; positive is right-handed.
        z: Heights of the nodes, shape (n,), mm.
    """
    s = z.copy()
    for _ in range(
        20
    ):  # `check_geometry` bounds the derivative from below: this converges in a few steps
        s -= (_about(helix, radius, phase, rate, s)[:, 2] - z) / climb(
            helix, radius, phase, rate, s
        )
    line = _about(helix, radius, phase, rate, s)
    line[:, 2] = z
    return line


def climb(helix: StrandHelix, radius: float, phase: float, rate: float, s: Array) -> Array:
    """Derivative of a yarn's z by the strand's height s, shape (n,); arguments as for `place_yarn`."""
    if helix.undulation is None:
        tilt = radius * helix.frame(s[:1])[1][0, 2]  # t x n rises by the same all along a helix
        return np.asarray(1.0 + tilt * rate * np.cos(phase + rate * s))
    step = 1e-5 * helix.undulation.spacing
    above, below = (_about(helix, radius, phase, rate, s + h)[:, 2] for h in (step, -step))
    return np.asarray((above - below) / (2.0 * step))


def _about(helix: StrandHelix, radius: float, phase: float, rate: float, s: Array) -> Array:
    """Points of a yarn in the planes normal to the strand at its heights s, shape (n, 3)."""
    outward, across = helix.frame(s)
    angle = (phase + rate * s)[:, None]
    return helix.point(s) + radius * (np.cos(angle) * outward + np.sin(angle) * across)
