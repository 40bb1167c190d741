"""Where strands of the two layers cross, and which one is outside."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.motif import Motif, stacking_order

Array = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Crossings:
    """Crossings of two strands within the sample, ordered by z, one row each (n rows).

    Nodes are uniform in z at the start, so z / length is the material coordinate of the crossing
    on both strands.
    """

    strand_a: Integers  # (n,), of layer 0
    strand_b: Integers  # (n,), of layer 1, numbered after those of layer 0
    z: Array  # (n,), mm
    order: Integers  # (n,), +1: a is outside b, -1: b is outside a
    direction: Array  # (n, 3), outward radial unit vector at the crossing

    def __len__(self) -> int:
        return len(self.z)


def no_crossings() -> Crossings:
    """Crossings of a rope that is not braided."""
    none = np.empty(0, dtype=np.int64)
    return Crossings(none, none, np.empty(0), none, np.empty((0, 3)))


def phase_offset(counts: tuple[int, int]) -> float:
    """Angle of layer 1 at z = 0, radians: the sample's ends fall midway between rings of crossings.

    Crossings lie on rings spaced pitch / (2 lcm(N0, N1)); the offset is half of that spacing.
    """
    return math.pi / math.lcm(*counts)


def find_crossings(motif: Motif, counts: tuple[int, int], pitch: float, length: float) -> Crossings:
    """All crossings with 0 < z < length.

    Line i of layer 0 is at the angle 2 pi (i / N0 + z / pitch), line j of layer 1, unrolled, at
    2 pi (j / N1 - z / pitch) + offset: they cross at z = pitch / 2 (j / N1 - i / N0) + shift.

    Args:
        motif: +1 / -1, shape (m0, m1).
        counts: Strands of layer 0 and of layer 1.
        pitch, length: mm.
    """
    shift = pitch * phase_offset(counts) / (4.0 * np.pi)
    turns = math.ceil(2.0 * length / pitch) + 2
    line_0, line_1 = np.meshgrid(
        np.arange(counts[0]), np.arange(-counts[1], turns * counts[1]), indexing="ij"
    )
    line_0, line_1 = line_0.ravel(), line_1.ravel()
    z = pitch / 2.0 * (line_1 / counts[1] - line_0 / counts[0]) + shift
    rank = np.lexsort((line_0, np.round(z / pitch, 9)))
    rank = rank[(z[rank] > 0.0) & (z[rank] < length)]
    line_0, line_1, z = line_0[rank], line_1[rank], z[rank]
    angle = 2.0 * np.pi * (line_0 / counts[0] + z / pitch)
    return Crossings(
        strand_a=line_0,
        strand_b=counts[0] + line_1 % counts[1],
        z=z,
        order=stacking_order(motif, line_0, line_1),
        direction=np.column_stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)]),
    )
