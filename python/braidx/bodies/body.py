"""What the rest of the program sees of a body: all yarns of one model at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import ufl
from dolfinx import fem
from mpi4py import MPI

from ..forms.curve import Part, integral, nodal, unit_tangent
from ..forms.variation import variations
from .assembled import AssembledBody
from .assembly import Assembler, compile_form
from .layout import CurveLayout, FloatArray, IntArray
from .mesh import ElementField, create_curve_mesh


class CurveBody(AssembledBody):
    """Many curves of one model: one mesh, one blocked space, one set of forms.

    A subclass creates its coefficients and calls `_set_energy`. All arrays are in canonical
    numbering: curve by curve, node by node, `block` components.

    Args:
        comm: Communicator; whole curves are dealt out to its ranks.
        centre_lines: Nodes of each curve in the reference configuration, shape (num_nodes_i, 3)
            each, mm.
        rest: Unknowns of the reference state, shape (num_nodes, block); the first three are
            positions, mm.
        degree: Degree of the line elements, 1 or 2.
        area: Cross-section, mm^2, one value, one per curve or one per element; None if only forces
            are asked for.
    Raises:
        ValueError: If a centre line has the wrong shape or coinciding neighbours.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        centre_lines: Sequence[FloatArray],
        rest: FloatArray,
        degree: int,
        area: npt.ArrayLike | None,
    ) -> None:
        self.comm = comm
        self.layout = CurveLayout.from_node_counts([len(line) for line in centre_lines], degree)
        self.block = rest.shape[1]
        self.rest = rest
        self._area = None if area is None else self.layout.per_element(area, "area")
        self._curve_mesh = create_curve_mesh(comm, self.layout, rest[:, :3])
        self._tangent = unit_tangent(self._curve_mesh.mesh.ufl_domain())
        self._space = self._curve_mesh.blocked_space(self.block)
        self._nodes = self._curve_mesh.space_nodes(self._space)
        self._state = fem.Function(self._space)
        self.set_state(rest)

    def _set_energy(
        self, parts: list[Part], axial_force: Any, foreseen: list[Part] | None = None
    ) -> None:
        """Compile the forms of the energy, and of the axial force (UFL scalar, N) for output.

        `foreseen` are the parts whose Hessian is the tangent, if they depend on the step (`set_step`).
        """
        forms = variations(parts, self._state, foreseen)
        self._assembler = Assembler(forms, self._space, self._nodes, self.num_nodes)
        self._mean = ElementField(self._curve_mesh)
        weight = ufl.TestFunction(self._mean.function.function_space)
        domain, degree = self._curve_mesh.mesh.ufl_domain(), self.layout.degree
        self._force_form = compile_form(integral(nodal(axial_force * weight, degree), domain))
        self._length_form = compile_form(integral(nodal(weight, degree), domain))

    @property
    def curves(self) -> IntArray:
        """First node of each curve and the number of nodes, shape (num_curves + 1,)."""
        return self.layout.curves

    @property
    def num_nodes(self) -> int:
        return self.layout.num_nodes

    @property
    def num_elements(self) -> int:
        return self.layout.num_elements

    def tension(self, q: FloatArray) -> FloatArray:
        """Mean axial force of each element in state `q`, N, positive when pulled.

        Shape (num_elements,), the same on each rank; leaves the body in state `q`.
        """
        self.set_state(q)
        local, lengths = np.zeros_like(self._mean.function.x.array), self._local_lengths()
        fem.assemble_vector(local, self._force_form)
        return self._mean.gather(local / lengths, self.num_elements)

    def axial_stress(self, q: FloatArray) -> FloatArray:
        """Tension over the cross-section at rest, MPa, shape (num_elements,), on each rank.

        Raises:
            ValueError: If the body was made without area.
        """
        if self._area is None:
            raise ValueError("axial stress needs the cross-section: give `area` to the body")
        return self.tension(q) / self._area

    def rest_lengths(self) -> FloatArray:
        """Length of each element in the reference configuration, mm, shape (num_elements,)."""
        return self._mean.gather(self._local_lengths(), self.num_elements)

    def curve_lengths(self) -> FloatArray:
        """Length of each curve in the reference configuration, mm, shape (num_curves,)."""
        return np.add.reduceat(self.rest_lengths(), self.layout.curve_elements[:-1])

    def _local_lengths(self) -> FloatArray:
        lengths = np.zeros_like(self._mean.function.x.array)
        fem.assemble_vector(lengths, self._length_form)
        return lengths
