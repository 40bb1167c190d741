"""The half section of a cylinder, dealt out to the ranks, with canonical numbering."""

from __future__ import annotations

import basix.ufl
import numpy as np
import numpy.typing as npt
from dolfinx import fem
from dolfinx import mesh as dolfinx_mesh
from mpi4py import MPI

from ..compat import keep_cells

FloatArray = npt.NDArray[np.float64]
DEGREE = 2  # the steady temperature of a uniform source is quadratic in r: exact


class CylinderMesh:
    """Rectangular cells in (r, z) and the temperature's space on them.

    Canonical cells: axial index fastest. Canonical nodes: those of degree 2, a grid of
    (2 radial cells + 1) x (2 axial cells + 1), axial index fastest.

    Args:
        comm: Communicator.
        radial_edges: Borders of the cells, mm, ascending, the first one 0 or the bore's radius.
        axial_edges: The same along the axis, mm.
    """

    def __init__(self, comm: MPI.Comm, radial_edges: FloatArray, axial_edges: FloatArray) -> None:
        self.comm = comm
        self.shape = (len(radial_edges) - 1, len(axial_edges) - 1)
        corners = np.stack(np.meshgrid(radial_edges, axial_edges, indexing="ij"), axis=-1)
        across, along = np.meshgrid(*map(np.arange, self.shape), indexing="ij")
        first = (across * len(axial_edges) + along).ravel()
        beyond = first + len(axial_edges)
        cells = np.stack([first, beyond, first + 1, beyond + 1], axis=1)
        own = np.array_split(np.arange(len(cells)), comm.size)[comm.rank]
        points = np.array_split(np.arange(corners.size // 2), comm.size)[comm.rank]
        self.mesh = dolfinx_mesh.create_mesh(
            comm,
            cells=cells[own].astype(np.int64),
            x=corners.reshape(-1, 2)[points],
            e=basix.ufl.element("Lagrange", "quadrilateral", 1, shape=(2,)),
            partitioner=keep_cells(len(own), comm.rank),
        )
        self.space = fem.functionspace(self.mesh, ("Lagrange", DEGREE))
        self.radial_nodes = _with_middles(radial_edges)
        self.axial_nodes = _with_middles(axial_edges)
        place = self.space.tabulate_dof_coordinates()
        self.nodes = _nearest(self.radial_nodes, place[:, 0]) * len(self.axial_nodes) + _nearest(
            self.axial_nodes, place[:, 1]
        )
        self.num_nodes = len(self.radial_nodes) * len(self.axial_nodes)
        self.cells = np.asarray(self.mesh.topology.original_cell_index, dtype=np.int64)

    def field(self) -> fem.Function:
        """A function that is constant in each cell."""
        return fem.Function(fem.functionspace(self.mesh, ("DG", 0)))

    def set_cells(self, field: fem.Function, values: FloatArray) -> None:
        """Set canonical values per cell, of the mesh's shape."""
        places = field.function_space.dofmap.list[:, 0]
        field.x.array[places] = values.ravel()[self.cells]


def _with_middles(edges: FloatArray) -> FloatArray:
    nodes = np.empty(2 * len(edges) - 1)
    nodes[::2], nodes[1::2] = edges, 0.5 * (edges[1:] + edges[:-1])
    return nodes


def _nearest(nodes: FloatArray, values: FloatArray) -> npt.NDArray[np.int64]:
    """Index of the node at each value; values are nodes up to round-off."""
    middles = 0.5 * (nodes[1:] + nodes[:-1])
    return np.searchsorted(middles, values).astype(np.int64)
