"""Scenes that several families use."""

from __future__ import annotations

import numpy as np

from braidx.rods import Beam, Rods, YarnMaterial, straight
from judge import Watch

HALF = 40.0  # length of a beam over the radius, by 2, at least
CLEAR = 2.6  # radii: how far to the side of the lower beam the ends of the upper one are, at least
PRESS = 2.0  # radii that ends go down
SLIDE = 6.0  # radii that they then go along


def crossing(
    angle: float,
    lengths: tuple[float, float] = (4.0, 4.0),
    radius: float = 1.0,
    modulus: float = 1000.0,
    **options: float | None,
) -> Rods:
    """Two beams that touch at a crossing angle (degrees), the lower one along x; their ends are clamped.

    Args:
        lengths: Of elements of the lower and the upper beam over the radius.
        options: Of Rods.
    """
    turned = np.radians(angle)
    half = max(HALF, CLEAR / np.sin(turned)) * radius
    along = half * np.array([[1.0, 0.0, 0.0], [np.cos(turned), np.sin(turned), 0.0]])
    height = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 2.0 * radius]])
    material = YarnMaterial.isotropic(modulus, 0.3)
    beams = []
    for to, up, length in zip(along, height, lengths, strict=True):
        spans = 2 * max(1, round(2 * half / (length * radius)))
        beams.append(Beam(straight(up - to, up + to, spans), radius, material))
    rods = Rods(beams, **options)
    for rod in (0, 1):
        rods.clamp(rod, [0, -1])
    return rods


def press(rods: Rods, watch: Watch, increments: int = 4, by: float = PRESS) -> bool:
    """The ends of the upper beam go down by some radii."""
    rods.move(1, [0, -1], by=(0.0, 0.0, -by * rods.rods[1].radius))
    return watch.solve(increments)


def slide(rods: Rods, watch: Watch, by: float, increments: int) -> bool:
    """The ends of the upper beam go along the lower one by some radii."""
    rods.move(1, [0, -1], by=(by * rods.rods[1].radius, 0.0, 0.0))
    return watch.solve(increments)


def lift(rods: Rods) -> float:
    """What holds the ends of the upper beam down, N."""
    return -float(sum(rods.reaction(1, node)[0][2] for node in (0, -1)))


def drag(rods: Rods) -> float:
    """What pulls the ends of the upper beam along the lower one, N."""
    return float(sum(rods.reaction(1, node)[0][0] for node in (0, -1)))
