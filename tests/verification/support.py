"""Curves as the scenes of solids need them; those of rods alone are set up through braidx.rods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from braidx.bodies import CableBody, CurveBody
from braidx.contact.tubes import TubeLayout

Floats = npt.NDArray[np.float64]


def tube_layout(body: CurveBody, radius: npt.ArrayLike) -> TubeLayout:
    """Tubes around the curves of a body whose unknowns come first."""
    curves, elements = body.curves, body.layout.curve_elements
    ones = np.ones(len(curves) - 1, dtype=np.int64)
    length = np.add.reduceat(body.rest_lengths(), elements[:-1]) / np.diff(elements)
    return TubeLayout(
        first_unknown=curves[:-1] * body.block,
        num_elements=np.diff(elements),
        degree=ones * body.layout.degree,
        block=ones * body.block,
        radius=radius * np.ones(len(ones)),
        element_length=length,
        body=0 * ones,
    )


def cables(
    lines: Sequence[Floats], axial_stiffness: npt.ArrayLike, tension: float = 0.0, degree: int = 1
) -> CableBody:
    """Cables along the given lines."""
    return CableBody(
        MPI.COMM_SELF, lines, axial_stiffness=axial_stiffness, tension=tension, degree=degree
    )
