"""Curves as the scenes of solids need them; those of rods alone are set up through braidx.rods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from braidx.bodies import CableBody

Floats = npt.NDArray[np.float64]


def cables(
    lines: Sequence[Floats], axial_stiffness: npt.ArrayLike, tension: float = 0.0, degree: int = 1
) -> CableBody:
    """Cables along the given lines."""
    return CableBody(
        MPI.COMM_SELF, lines, axial_stiffness=axial_stiffness, tension=tension, degree=degree
    )
