"""One distributed mesh of disconnected curves, and its maps to the canonical numbering."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import basix.ufl
import numpy as np
from dolfinx import fem
from dolfinx import mesh as dolfinx_mesh
from mpi4py import MPI

from ..compat import keep_cells
from .layout import CurveLayout, FloatArray, IntArray


@dataclass(frozen=True)
class CurveMesh:
    """A mesh whose geometry is the reference configuration of all curves."""

    layout: CurveLayout
    mesh: dolfinx_mesh.Mesh
    cell_elements: IntArray  # canonical element of each local cell
    geometry_nodes: IntArray  # canonical node of each local point of the geometry

    def move(self, positions: FloatArray) -> None:
        """Make `positions`, canonical, shape (num_nodes, 3), mm, the reference configuration."""
        self.mesh.geometry.x[:] = positions[self.geometry_nodes]

    def blocked_space(self, block: int) -> fem.FunctionSpace:
        """Continuous space of the elements' degree with `block` components."""
        element = basix.ufl.element("Lagrange", "interval", self.layout.degree, shape=(block,))
        return fem.functionspace(self.mesh, element)

    def space_nodes(self, space: fem.FunctionSpace) -> IntArray:
        """Canonical node of each local block of degrees of freedom, owned first, then ghosts."""
        index_map = space.dofmap.index_map
        nodes = np.full(index_map.size_local + index_map.num_ghosts, -1, dtype=np.int64)
        nodes[space.dofmap.list] = self.layout.elements[self.cell_elements]
        assert np.all(nodes >= 0), "a node without a cell on this rank"
        return nodes


class Domain(Protocol):
    """A distributed mesh that knows the canonical element of each of its cells."""

    @property
    def mesh(self) -> dolfinx_mesh.Mesh: ...

    @property
    def cell_elements(self) -> IntArray: ...


class ElementField:
    """Values that are constant in each element, for use as coefficients of forms.

    Attributes:
        function: DOLFINx function of degree 0; UFL sees a vector, or a scalar if there is one
            component.
    """

    def __init__(self, domain: Domain, components: int = 1) -> None:
        shape = () if components == 1 else (components,)
        element = basix.ufl.element("DG", domain.mesh.basix_cell(), 0, shape=shape)
        self.function = fem.Function(fem.functionspace(domain.mesh, element))
        cells = self.function.function_space.dofmap.list[:, 0]
        self._elements = np.empty(len(cells), dtype=np.int64)
        self._elements[cells] = domain.cell_elements

    def set(self, values: FloatArray) -> None:
        """Set canonical values, shape (num_elements,) or (num_elements, components)."""
        self.function.x.array[:] = values[self._elements].ravel()

    def gather(self, local: FloatArray, num_elements: int) -> FloatArray:
        """Bring values in local order, shape (num_cells components,), to all ranks in canonical order."""
        result = np.zeros((num_elements, *self.function.ufl_shape))
        result[self._elements] = local.reshape(-1, *self.function.ufl_shape)
        comm = self.function.function_space.mesh.comm
        comm.Allreduce(MPI.IN_PLACE, result)
        return result


def create_curve_mesh(comm: MPI.Comm, layout: CurveLayout, positions: FloatArray) -> CurveMesh:
    """Mesh the curves; each rank supplies and keeps a contiguous chunk of them.

    Args:
        comm: Communicator of all ranks that hold `positions`.
        layout: Canonical numbering.
        positions: Canonical reference positions, the same on each rank, shape (num_nodes, 3), mm.
    """
    elements, nodes = layout.chunk(comm.rank, comm.size)
    coordinates = basix.ufl.element("Lagrange", "interval", layout.degree, shape=(3,))
    cells = layout.elements[elements]
    mesh = dolfinx_mesh.create_mesh(
        comm,
        cells=cells,
        x=positions[nodes],
        e=coordinates,
        partitioner=keep_cells(len(cells), comm.rank),
    )
    return CurveMesh(
        layout=layout,
        mesh=mesh,
        cell_elements=np.asarray(mesh.topology.original_cell_index, dtype=np.int64),
        geometry_nodes=np.asarray(mesh.geometry.input_global_indices, dtype=np.int64),
    )
