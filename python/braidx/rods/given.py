"""Numbers that a scene of rods is given: refused here where they are none."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ..system.terms import Floats


def numbers(name: str, value: npt.ArrayLike, *shape: int) -> Floats:
    """An array of finite numbers of this shape.

    Raises:
        ValueError: If it has another shape, or a number in it is NaN or infinite.
    """
    array = np.asarray(value, dtype=float)
    if array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}: give {shape}")
    if not np.all(np.isfinite(array)):
        raise ValueError(f"{name} is {array}: give finite numbers")
    return array
