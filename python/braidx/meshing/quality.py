"""Checks of a mesh of solids, before anything expensive is made of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np

from .reference import SOLID_CELLS, FloatArray, IntArray, ReferenceCell
from .swept import Sweep


class Mesh(Protocol):
    """What checks ask of a mesh, see SolidMesh."""

    @property
    def points(self) -> FloatArray: ...
    @property
    def cells(self) -> IntArray: ...
    @property
    def cell_part(self) -> IntArray: ...
    @property
    def fibre(self) -> FloatArray: ...
    @property
    def facets(self) -> Mapping[str, IntArray]: ...
    @property
    def sweeps(self) -> Mapping[int, Sweep]: ...
    @property
    def cell(self) -> ReferenceCell: ...
    @property
    def num_cells(self) -> int: ...


def check_shapes(mesh: Mesh) -> None:
    """Raises ValueError if arrays of the mesh do not fit together."""
    if mesh.cells.ndim != 2 or mesh.cells.shape[1] not in SOLID_CELLS or not len(mesh.cells):
        raise ValueError(
            f"cells has shape {mesh.cells.shape}: give (num_cells, n), n = 8 or 27 for hexahedra, "
            "4 or 10 for tetrahedra"
        )
    n = len(mesh.cells)
    for name, array, shape in (
        ("points", mesh.points, (len(mesh.points), 3)),
        ("cell_part", mesh.cell_part, (n,)),
        ("fibre", mesh.fibre, (n, 3)),
    ):
        if array.shape != shape:
            raise ValueError(f"{name} has shape {array.shape}: give {shape}")
        if not np.all(np.isfinite(array)):
            raise ValueError(f"{name} is not finite")
    if np.abs(np.linalg.norm(mesh.fibre, axis=1) - 1.0).max() > 1e-9:
        raise ValueError("fibre has rows whose length is not 1: give unit vectors")


def check_nodes(mesh: Mesh) -> None:
    """Raises ValueError if a cell names a node that is not there, or a node belongs to no cell."""
    if mesh.cells.min() < 0 or mesh.cells.max() >= len(mesh.points):
        raise ValueError(
            f"cells name the nodes {mesh.cells.min()} to {mesh.cells.max()}: "
            f"there are 0 to {len(mesh.points) - 1}"
        )
    used = np.zeros(len(mesh.points), dtype=bool)
    used[mesh.cells] = True
    if not used.all():
        raise ValueError(
            f"{np.count_nonzero(~used)} nodes belong to no cell, the first is node "
            f"{np.argmin(used)}: remove them from points"
        )


def scaled_jacobians(mesh: Mesh) -> FloatArray:
    """Smallest scaled Jacobian of each cell at its nodes, shape (num_cells,): 1 is a cube, <= 0 inside out."""
    gradient = mesh.cell.gradient(mesh.cell.points)
    axes = np.einsum("pdn,cni->cpdi", gradient, mesh.points[mesh.cells])
    lengths = np.linalg.norm(axes, axis=3).prod(axis=2)
    return np.asarray((np.linalg.det(axes) / np.maximum(lengths, 1e-300)).min(axis=1))


def check_facets(mesh: Mesh) -> None:
    """Raises ValueError if a surface names facets that are not there, or a cell is inside out."""
    limit = np.array([mesh.num_cells, len(mesh.cell.facets)])
    for tag, pairs in mesh.facets.items():
        if pairs.ndim != 2 or pairs.shape[1] != 2 or np.any(pairs < 0) or np.any(pairs >= limit):
            raise ValueError(
                f'surface "{tag}": give pairs (cell, local facet) below {tuple(limit)}, shape (n, 2)'
            )
    quality = scaled_jacobians(mesh)
    worst = int(quality.argmin())
    if not quality[worst] > 0.0:
        part = int(mesh.cell_part[worst])
        sweep = mesh.sweeps.get(part)
        cure = "mesh it anew" if sweep is None else _bend(sweep, worst)
        raise ValueError(
            f"cell {worst} of part {part} is inside out (scaled Jacobian {quality[worst]:.2g}; "
            f"{np.count_nonzero(quality <= 0.0)} cells are): {cure}"
        )


def _bend(sweep: Sweep, cell: int) -> str:
    """How a swept part is bent at a cell, and what helps."""
    element = int(np.argwhere(sweep.cells == cell)[0, 0])
    first = element * (len(sweep.layers) - 1) // len(sweep.cells)
    steps = np.diff(sweep.line, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    near = slice(max(first - 1, 0), first + 2)
    tangents = steps[near] / lengths[near, None]
    turn = np.linalg.norm(np.diff(tangents, axis=0), axis=1).max(initial=1e-300)
    step = lengths[first]
    radius = step / max(turn, 1e-300)
    reach = np.linalg.norm(sweep.section, axis=1).max()
    return (
        f"at layer {first} its centre line bends with a radius of {radius:.3g} mm in steps of {step:.3g} mm, "
        f"the section reaches {reach:.3g} mm; take a smaller radius, a coarser sweep or a smoother centre line"
    )
