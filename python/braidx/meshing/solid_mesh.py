"""Meshes of solids in canonical numbering, and what contact and coupling ask of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches

import numpy as np

from .quality import check_facets, check_nodes, check_shapes
from .reference import SOLID_CELLS, FloatArray, IntArray, ReferenceCell
from .swept import Sweep


@dataclass(frozen=True)
class SolidMesh:
    """Hexahedra or tetrahedra of one degree.

    Attributes:
        points: Nodes, shape (num_nodes, 3), mm.
        cells: Nodes of each cell in the order of basix, shape (num_cells, 8, 27, 4 or 10).
        cell_part: Part (yarn, core) that each cell belongs to, shape (num_cells,).
        fibre: Unit direction of the fibres in each cell, shape (num_cells, 3).
        facets: (cell, local facet) of named surfaces, shape (num_facets, 2) each.
        sweeps: Parts that were swept along a line.
        part_names: Name of each part, or nothing.
    Raises:
        ValueError: If a shape does not fit, a node belongs to no cell or a cell is turned inside out.
    """

    points: FloatArray
    cells: IntArray
    cell_part: IntArray
    fibre: FloatArray
    facets: Mapping[str, IntArray]
    sweeps: Mapping[int, Sweep] = field(default_factory=dict)
    part_names: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        check_shapes(self)
        check_nodes(self)
        check_facets(self)

    @property
    def cell(self) -> ReferenceCell:
        return SOLID_CELLS[self.cells.shape[1]]

    @property
    def degree(self) -> int:
        return self.cell.degree

    @property
    def num_nodes(self) -> int:
        return len(self.points)

    @property
    def num_cells(self) -> int:
        return len(self.cells)

    @property
    def num_parts(self) -> int:
        return int(self.cell_part.max()) + 1

    @property
    def is_swept(self) -> bool:
        """Whether the third axis of every cell runs along the fibre of a swept part."""
        return len(self.sweeps) == self.num_parts

    def cells_of(self, part: int) -> IntArray:
        """Cells of a part, shape (n,).

        Raises:
            ValueError: If there is no such part.
        """
        if not 0 <= part < self.num_parts:
            raise ValueError(f"part {part}: the mesh has the parts 0 to {self.num_parts - 1}")
        return np.flatnonzero(self.cell_part == part)

    def facets_of(self, tag: str, part: int | None = None) -> IntArray:
        """(cell, local facet) of a surface, of one part or of all, shape (num_facets, 2).

        Raises:
            ValueError: If there is no such surface.
        """
        if tag not in self.facets:
            known = ", ".join(f'"{name}"' for name in sorted(self.facets)) or "none"
            close = get_close_matches(tag, self.facets, n=1, cutoff=0.5)
            hint = f'; did you mean "{close[0]}"?' if close else ""
            raise ValueError(f'the mesh has no surface "{tag}", it has: {known}{hint}')
        facets = self.facets[tag]
        return facets if part is None else facets[self.cell_part[facets[:, 0]] == part]

    def facet_nodes(self, tag: str, part: int | None = None) -> IntArray:
        """Nodes of the facets of a surface, shape (num_facets, 4, 9, 3 or 6).

        In the order of basix (vertices, edges, interior); a quadrilateral's vertices are at (u, v) = (0, 0), (1, 0),
        (0, 1), (1, 1). (dx/du) x (dx/dv) points outward.

        Raises:
            ValueError: If there is no such surface.
        """
        cell, facet = self.facets_of(tag, part).T
        return self.cells[cell[:, None], self.cell.facets[facet]]


def join(meshes: Sequence[SolidMesh]) -> SolidMesh:
    """One mesh of several that share no node; parts are numbered through, surfaces of one name become one.

    Raises:
        ValueError: If there is no mesh, or the cells differ in kind or degree.
    """
    if not meshes:
        raise ValueError("meshes is empty: give at least one mesh to join")
    kinds = {(m.cell.name, m.degree) for m in meshes}
    if len(kinds) > 1:
        names = " and ".join(f"{name} of degree {degree}" for name, degree in sorted(kinds))
        raise ValueError(
            f"meshes have {names}: one mesh takes one kind of cell; make a body of each"
        )
    nodes = np.cumsum([0] + [m.num_nodes for m in meshes])
    cells = np.cumsum([0] + [m.num_cells for m in meshes])
    parts = np.cumsum([0] + [m.num_parts for m in meshes])
    facets: dict[str, list[IntArray]] = {}
    for mesh, first in zip(meshes, cells):
        for tag, pairs in mesh.facets.items():
            facets.setdefault(tag, []).append(pairs + [first, 0])
    return SolidMesh(
        points=np.concatenate([m.points for m in meshes]),
        cells=np.concatenate([m.cells + first for m, first in zip(meshes, nodes)]),
        cell_part=np.concatenate([m.cell_part + first for m, first in zip(meshes, parts)]),
        fibre=np.concatenate([m.fibre for m in meshes]),
        facets={tag: np.concatenate(pairs) for tag, pairs in facets.items()},
        sweeps={
            int(part + parts[i]): sweep.moved(nodes[i], cells[i])
            for i, mesh in enumerate(meshes)
            for part, sweep in mesh.sweeps.items()
        },
        part_names=tuple(name for m in meshes for name in m.part_names or [""] * m.num_parts),
    )
