"""Temperature of a rope as a cylinder of one material, with sources inside and air around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import ufl
from dolfinx import fem
from mpi4py import MPI
from scipy import sparse
from scipy.sparse.linalg import splu

from ..bodies.assembly import Assembler, compile_form
from ..forms import heat
from ..forms.variation import Variation
from .cylinder_mesh import DEGREE, CylinderMesh
from .material import ThermalMaterial
from .source import cell_volumes

FloatArray = npt.NDArray[np.float64]
_QUADRATURE = 2 * DEGREE + 1  # exact: two fields of degree 2 times r


@dataclass(frozen=True)
class HeatHistory:
    """Course of the temperature over n steps, the start included in every array."""

    time: FloatArray  # (n + 1,), s
    maximum: FloatArray  # (n + 1,), degrees C
    mean: FloatArray  # (n + 1,), degrees C, over the volume
    stored: FloatArray  # (n + 1,), J, above ambient temperature
    given_off: FloatArray  # (n + 1,), J, by the surface since the start
    generated: FloatArray  # (n + 1,), J, by the sources since the start
    field: FloatArray  # (radial nodes, axial nodes), degrees C, at the end


class RopeHeat:
    """Transient conduction, backward Euler, convection at the lateral surface, insulated ends.

    A step may be long against a bending cycle: the sources are means over cycles. Every rank has
    the whole matrix; it is small.

    Args:
        comm: Communicator; each rank assembles its share of the cells.
        radial_edges: Borders of the cells, mm, ascending, the first one 0 or the bore's radius.
        axial_edges: The same along the axis, mm.
        material: Thermal properties.
    Raises:
        ValueError: If the edges do not ascend or the first radius is negative.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        radial_edges: FloatArray,
        axial_edges: FloatArray,
        material: ThermalMaterial,
    ) -> None:
        for name, edges in (("radial", radial_edges), ("axial", axial_edges)):
            if len(edges) < 2 or (np.diff(edges) <= 0).any():
                raise ValueError(f"{name} edges of the cells: {edges}; give ascending numbers.")
        if radial_edges[0] < 0.0:
            raise ValueError(f"radial edges begin at {radial_edges[0]} mm; begin at 0 or above.")
        self.radial_edges, self.axial_edges = np.asarray(radial_edges), np.asarray(axial_edges)
        self.material = material
        self.mesh = CylinderMesh(comm, self.radial_edges, self.axial_edges)
        unknown = fem.Function(self.mesh.space)
        properties = [
            fem.Constant(self.mesh.mesh, float(value))
            for value in (material.capacity, material.across, material.along, material.transfer)
        ]
        capacity, across, along, transfer = properties
        self.capacity = self._matrix(heat.capacity(unknown, capacity, _QUADRATURE))
        conduction = self._matrix(heat.conduction(unknown, across, along, _QUADRATURE))
        self.convection = self._matrix(heat.convection(unknown, transfer, _QUADRATURE))
        self.stiffness = conduction + self.convection
        self._density = self.mesh.field()
        test = ufl.TestFunction(self.mesh.space)
        self._source = compile_form(heat.source(test, self._density, _QUADRATURE))
        self.power = np.zeros(self.mesh.num_nodes)  # W, on each node

    @property
    def num_cells(self) -> tuple[int, int]:
        """Radial and axial number of cells."""
        return self.mesh.shape

    @property
    def nodes(self) -> tuple[FloatArray, FloatArray]:
        """Radii and heights of the nodes of a field, mm."""
        return self.mesh.radial_nodes, self.mesh.axial_nodes

    def set_source(self, density: FloatArray) -> None:
        """Set the power density, shape (radial cells, axial cells), W/mm^3 (`spread` makes it)."""
        if np.shape(density) != self.num_cells:
            raise ValueError(
                f"heat source: shape {np.shape(density)}, the cells have {self.num_cells}."
            )
        self.mesh.set_cells(self._density, np.asarray(density, dtype=float))
        local = np.zeros(len(self.mesh.nodes))
        fem.assemble_vector(local, self._source)
        power = np.zeros(self.mesh.num_nodes)
        np.add.at(power, self.mesh.nodes, local)
        self.mesh.comm.Allreduce(MPI.IN_PLACE, power)
        self.power = power

    def steady(self) -> FloatArray:
        """Temperature in the end, shape (radial nodes, axial nodes), degrees C."""
        return self._grid(splu(self.stiffness.tocsc()).solve(self.power) + self.material.ambient)

    def run(self, duration: float, steps: int, initial: FloatArray | None = None) -> HeatHistory:
        """Let time pass with the sources as set.

        Args:
            duration: s.
            steps: Number of equal time steps.
            initial: Temperature at the start, shape (radial nodes, axial nodes), degrees C; ambient
                if None.
        Raises:
            ValueError: If duration or number of steps is not positive.
        """
        if duration <= 0.0 or steps < 1:
            raise ValueError(f"heat: {duration} s in {steps} steps; give positive numbers.")
        length = duration / steps
        above: FloatArray = np.zeros(self.mesh.num_nodes)
        if initial is not None:
            above = np.asarray(initial, dtype=float).ravel() - self.material.ambient
        solve = splu((self.capacity / length + self.stiffness).tocsc()).solve
        states, given_off = [above], [0.0]
        for _ in range(steps):
            above = solve(self.capacity @ above / length + self.power)
            states.append(above)
            given_off.append(given_off[-1] + length * float((self.convection @ above).sum()))
        stored = np.array([float((self.capacity @ state).sum()) for state in states])
        time: FloatArray = np.linspace(0.0, duration, steps + 1, dtype=np.float64)
        volume = float(cell_volumes(self.radial_edges, self.axial_edges).sum())
        return HeatHistory(
            time=time,
            maximum=np.array([state.max() for state in states]) + self.material.ambient,
            mean=stored / (self.material.capacity * volume) + self.material.ambient,
            stored=stored,
            given_off=np.array(given_off),
            generated=time * float(self.power.sum()),
            field=self._grid(above + self.material.ambient),
        )

    def _grid(self, values: FloatArray) -> FloatArray:
        return values.reshape(len(self.mesh.radial_nodes), len(self.mesh.axial_nodes))

    def _matrix(self, variation: Variation) -> sparse.csr_matrix:
        """The second derivative of a functional, whole on every rank."""
        mesh = self.mesh
        assembler = Assembler([variation], mesh.space, mesh.nodes, mesh.num_nodes)
        rows, columns = assembler.tangent_pattern()
        parts = mesh.comm.allgather((assembler.tangent_values().copy(), rows, columns))
        values, all_rows, all_columns = (np.concatenate(column) for column in zip(*parts))
        shape = (mesh.num_nodes, mesh.num_nodes)
        return sparse.coo_matrix((values, (all_rows, all_columns)), shape=shape).tocsr()
