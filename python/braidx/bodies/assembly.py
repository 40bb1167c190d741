"""Compile the variations of a stored energy once and assemble them into storage that is reused."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import ufl
from dolfinx import fem

from ..forms.variation import Variation
from .layout import FloatArray, IntArray

# The generated kernels are small; higher levels double the compile time for a few percent of speed.
JIT_OPTIONS: dict[str, Any] = {"cffi_extra_compile_args": ["-O2", "-g0"], "timeout": 600}


def compile_form(form: ufl.Form) -> fem.Form:
    """Compile a form with the options of this program; cached between runs."""
    return fem.form(form, jit_options=JIT_OPTIONS)


class Assembler:
    """Energy, residual and tangent of one body in canonical numbering.

    Values are the contributions of this rank: summed over the ranks they are the body's. Rows and
    columns may repeat between ranks, never within one.

    Args:
        variations: One per quadrature; each is compiled on its own and the results are
            added.
        space: The blocked space of the unknowns.
        nodes: Canonical node of each local block of `space`.
        num_nodes: Number of nodes of the body.
    """

    def __init__(
        self,
        variations: list[Variation],
        space: fem.FunctionSpace,
        nodes: IntArray,
        num_nodes: int,
    ) -> None:
        self._energies = [compile_form(v.energy) for v in variations]
        self._residuals = [compile_form(v.residual) for v in variations]
        self._tangents = [compile_form(v.tangent) for v in variations]
        self._block = space.dofmap.index_map_bs
        self._nodes = nodes
        self._matrix = fem.create_matrix(self._tangents[0])
        self._local = np.zeros(len(nodes) * self._block)
        self._residual = np.zeros((num_nodes, self._block))
        self._column_nodes = self._columns(space)

    def _columns(self, space: fem.FunctionSpace) -> IntArray:
        """Canonical node of each local column; columns may reach beyond the ghosts of `space`."""
        rows, columns = space.dofmap.index_map, self._matrix.index_map(1)
        owned = space.mesh.comm.allgather(self._nodes[: rows.size_local])
        local = np.arange(columns.size_local + columns.num_ghosts, dtype=np.int32)
        return np.concatenate(owned)[columns.local_to_global(local)]

    def energy(self) -> float:
        """Stored energy, mJ."""
        return float(sum(fem.assemble_scalar(form) for form in self._energies))

    def residual(self) -> FloatArray:
        """Gradient of the energy, shape (num_nodes block,); storage reused by the next call."""
        self._local[:] = 0.0
        for form in self._residuals:
            fem.assemble_vector(self._local, form)
        self._residual[self._nodes] = self._local.reshape(-1, self._block)
        return self._residual.ravel()

    def tangent_pattern(self) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
        """Rows and columns of `tangent_values`, two arrays of shape (num_entries,)."""
        row_nodes = np.repeat(self._nodes, np.diff(self._matrix.indptr))
        column_nodes = self._column_nodes[self._matrix.indices]
        component = np.arange(self._block)
        rows = self._block * row_nodes[:, None, None] + component[None, :, None]
        columns = self._block * column_nodes[:, None, None] + component[None, None, :]
        shape = (len(row_nodes), self._block, self._block)
        return (
            np.broadcast_to(rows, shape).ravel().astype(np.int32),
            np.broadcast_to(columns, shape).ravel().astype(np.int32),
        )

    def tangent_values(self) -> FloatArray:
        """Hessian of the energy, shape (num_entries,); the storage is reused by the next call."""
        self._matrix.set_value(np.float64(0.0))
        for form in self._tangents:
            fem.assemble_matrix(self._matrix, form)  # type: ignore[arg-type]
        return np.asarray(self._matrix.data)
