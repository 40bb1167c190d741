"""Centre lines, below each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def stack_lines(centre_lines: Sequence[FloatArray]) -> FloatArray:
    """Put the nodes of all curves below each other, shape (num_nodes, 3), mm.

    Raises:
        ValueError: If there is no curve, a shape is not (n, 3), a value not finite or two
            neighbours coincide.
    """
    if not centre_lines:
        raise ValueError("centre_lines is empty: a body needs at least one curve")
    for i, line in enumerate(centre_lines):
        points = np.asarray(line)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"centre line {i} has shape {points.shape}: give (num_nodes, 3)")
        if not np.all(np.isfinite(points)):
            raise ValueError(f"centre line {i} is not finite")
        if np.any(np.all(np.diff(points, axis=0) == 0.0, axis=1)):
            raise ValueError(f"centre line {i} has coinciding neighbours: remove the doubles")
    return np.concatenate([np.asarray(line, dtype=np.float64) for line in centre_lines])
