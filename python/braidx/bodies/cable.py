"""Yarns as cables: three unknowns per node, the current position."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..forms import cable
from ..geometry.lines import stack_lines
from .body import CurveBody
from .layout import FloatArray
from .mesh import ElementField


class CableBody(CurveBody):
    """Curves that resist stretching only (forms.cable).

    Args:
        comm: Communicator.
        centre_lines: Reference configuration, shape (num_nodes_i, 3) each, mm.
        axial_stiffness: EA, N, positive; one value, one per curve or one per element.
        tension: Tension T0 in the reference configuration, N; likewise.
        degree: Degree of the line elements, 1 or 2.
        area: Cross-section, mm^2, likewise; only `axial_stress` asks for it.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        centre_lines: Sequence[FloatArray],
        *,
        axial_stiffness: npt.ArrayLike,
        tension: npt.ArrayLike = 0.0,
        degree: int = 1,
        area: npt.ArrayLike | None = None,
    ) -> None:
        super().__init__(comm, centre_lines, stack_lines(centre_lines), degree, area)
        self._axial_stiffness = ElementField(self._curve_mesh)
        self._tension = ElementField(self._curve_mesh)
        self.set_properties(axial_stiffness=axial_stiffness, tension=tension)
        arguments = (
            self._state,
            self._tangent,
            self._axial_stiffness.function,
            self._tension.function,
        )
        self._set_energy(
            cable.energy(*arguments, degree),
            cable.axial_force(*arguments),
            cable.supported(*arguments, degree),
        )

    def set_properties(
        self,
        *,
        axial_stiffness: npt.ArrayLike | None = None,
        tension: npt.ArrayLike | None = None,
    ) -> None:
        """Change EA or T0 (N), as in the constructor; what is None stays.

        Raises:
            ValueError: If EA is not positive, T0 negative, or a value of the wrong shape.
        """
        for field, values, name, bound in (
            (self._axial_stiffness, axial_stiffness, "axial_stiffness", "be positive"),
            (self._tension, tension, "tension", "not be negative"),
        ):
            if values is None:
                continue
            spread = self.layout.per_element(values, name)
            if np.any(spread < 0.0) or (field is self._axial_stiffness and not spread.all()):
                raise ValueError(f"{name} is {spread.min()} N: it must {bound}")
            field.set(spread)

    def set_reference(self, q: FloatArray) -> None:
        """Make state `q`, shape (num_nodes, 3), mm, the reference; its tension is kept as T0."""
        tension = self.tension(q)
        self._curve_mesh.move(q)
        self.rest = np.array(q, dtype=np.float64)
        self.set_properties(tension=tension)
