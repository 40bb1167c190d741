"""One distributed mesh of solids, and its maps to the canonical numbering."""

from __future__ import annotations

from dataclasses import dataclass

import basix.ufl
import numpy as np
from dolfinx import fem
from dolfinx import mesh as dolfinx_mesh
from mpi4py import MPI

from ..compat import keep_cells
from ..meshing.solid_mesh import SolidMesh
from .layout import IntArray


@dataclass(frozen=True)
class SolidDomain:
    """A mesh whose geometry is the reference configuration."""

    solid: SolidMesh
    mesh: dolfinx_mesh.Mesh
    cell_elements: IntArray  # canonical cell of each local cell

    def position_space(self) -> fem.FunctionSpace:
        """Continuous space of the cells' degree with three components."""
        cell = self.solid.cell
        element = basix.ufl.element("Lagrange", cell.name, cell.degree, shape=(3,))
        return fem.functionspace(self.mesh, element)

    def space_nodes(self, space: fem.FunctionSpace) -> IntArray:
        """Canonical node of each local block of degrees of freedom, owned first, then ghosts."""
        index_map = space.dofmap.index_map
        nodes = np.full(index_map.size_local + index_map.num_ghosts, -1, dtype=np.int64)
        nodes[space.dofmap.list] = self.solid.cells[self.cell_elements]
        assert np.all(nodes >= 0), "a node without a cell on this rank"
        return nodes


def create_solid_domain(comm: MPI.Comm, solid: SolidMesh) -> SolidDomain:
    """Distribute a mesh that every rank holds; each rank supplies and keeps a contiguous chunk of cells.

    Whole parts while there are enough of them, so that ranks share no node; else parts are cut.
    """
    cuts = np.linspace(0, solid.num_cells, comm.size + 1).astype(np.int64)
    if solid.num_parts >= comm.size:
        starts = np.flatnonzero(np.diff(solid.cell_part, prepend=-1, append=-1))
        cuts = starts[np.abs(starts[:, None] - cuts[None, :]).argmin(axis=0)]
    mine = solid.cells[cuts[comm.rank] : cuts[comm.rank + 1]]
    nodes = np.linspace(0, solid.num_nodes, comm.size + 1).astype(np.int64)
    cell = solid.cell
    mesh = dolfinx_mesh.create_mesh(
        comm,
        cells=mine,
        x=solid.points[nodes[comm.rank] : nodes[comm.rank + 1]],
        e=basix.ufl.element("Lagrange", cell.name, cell.degree, shape=(3,)),
        partitioner=keep_cells(len(mine), comm.rank),
    )
    return SolidDomain(solid, mesh, np.asarray(mesh.topology.original_cell_index, dtype=np.int64))
