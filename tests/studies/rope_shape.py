"""How strands and yarns of a straight rope lie, read off a state of it."""

from __future__ import annotations

import math

import numpy as np
from pulled_values import Array

from braidx.output import Snapshot


def strand_lines(snapshot: Snapshot, z: Array) -> Array:
    """Centre lines of the strands at heights z, means over their yarns, shape (num_strands, len(z), 2), mm."""
    across = np.array(
        [
            [np.interp(z, line[:, 2], line[:, axis]) for axis in (0, 1)]
            for line in snapshot.centre_lines
        ]
    )
    strands = np.unique(snapshot.strand)
    means = [across[snapshot.strand == strand].mean(axis=0).T for strand in strands]
    return np.array(means)


def strand_radius(snapshot: Snapshot, samples: int = 400) -> float:
    """Mean distance of the strands' centre lines from the rope's axis, mm."""
    low = max(line[0, 2] for line in snapshot.centre_lines)
    high = min(line[-1, 2] for line in snapshot.centre_lines)
    lines = strand_lines(snapshot, np.linspace(low, high, samples))
    return float(np.linalg.norm(lines, axis=2).mean())


def helix_angle(radius: float, pitch: float) -> float:
    """Angle of a helix from its axis, radians. Source: paper 1, 5.2.3."""
    return math.atan(2.0 * math.pi * radius / pitch)


def efficiency_of_directions(snapshot: Snapshot) -> float:
    """Stiffness of the rope over that of its yarns if pieces of yarn followed the rope's strain at constant width, -.

    A piece ds at the angle a from the axis is then strained by cos^2 a times the rope's strain, and works on as much:
    the sum of cos^4 a ds over the yarns' number and the rope's length. A helix has cos^3 a.
    """
    lines = snapshot.centre_lines
    steps = np.concatenate([np.diff(line, axis=0) for line in lines])
    work = steps[:, 2] ** 4 / np.linalg.norm(steps, axis=1) ** 3
    return float(work.sum() / sum(np.ptp(line[:, 2]) for line in lines))
