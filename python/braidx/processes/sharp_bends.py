"""Yarns that are bent so sharply, while a rope is formed, that tubes about them are no yarns any more."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..system.constraints import Floats

HOOKED = 2.0  # radius of curvature over that of the yarn, of one that lies across another


def sharpest_bend(lines: Sequence[Floats], radius: Floats) -> tuple[float, int]:
    """Least radius of curvature of all yarns over their own radius, and the yarn.

    Args:
        lines: Nodes of the centre line of each yarn, shape (num_nodes, 3), mm.
        radius: Of each yarn, shape (num_yarns,), mm.
    """
    ratios = [_radius_of_curvature(line) / float(r) for line, r in zip(lines, radius, strict=True)]
    sharpest = int(np.argmin(ratios))
    return ratios[sharpest], sharpest


def _radius_of_curvature(line: Floats) -> float:
    """Least one of the circles through three nodes that follow each other, mm."""
    first, second = line[1:-1] - line[:-2], line[2:] - line[1:-1]
    sides = [np.linalg.norm(side, axis=1) for side in (first, second, first + second)]
    twice_area = np.linalg.norm(np.cross(first, second), axis=1)
    return float((np.prod(sides, axis=0) / np.maximum(2.0 * twice_area, 1e-300)).min())
