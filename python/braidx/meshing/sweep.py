"""Sweep the mesh of a section along a centre line."""

from __future__ import annotations

import numpy as np

from ..geometry.frames import check_right_handed, rotation_minimising_frames
from ..geometry.lines import stack_lines
from .reference import HEXAHEDRA, FloatArray, IntArray, ReferenceCell
from .section import SectionMesh
from .solid_mesh import SolidMesh, Sweep


def sweep(line: FloatArray, section: SectionMesh, directors: FloatArray | None = None) -> SolidMesh:
    """Hexahedra along a line, one layer of nodes in the plane of the directors at each of its points.

    Args:
        line: Centre of each layer of nodes, shape (num_layers, 3), mm; degree 2 takes an odd number, ends and
            middles of elements in turn.
        section: Mesh of the section; its degree is that of the hexahedra.
        directors: g1, g2 of each layer, shape (num_layers, 2, 3); rotation minimising by default.
    Returns:
        Mesh of one part with the surfaces "lateral", "start", "end" and, if hollow, "inner". Nodes are numbered layer
        by layer, cells element by element along the line, each in the order of `section`; the third axis of every
        cell runs along the line.
    Raises:
        ValueError: If the line does not fit, or bends too sharply for the section.
    """
    line = stack_lines([line])
    degree = section.degree
    num_elements, rest = divmod(len(line) - 1, degree)
    if rest or num_elements < 1:
        raise ValueError(
            f"line has {len(line)} points: give {degree} n + 1 points, n >= 1, for cells of degree {degree}"
        )
    if directors is None:
        (directors,) = rotation_minimising_frames([line])
    check_right_handed(line, directors, "directors")
    per_layer, per_element = len(section.points), len(section.quads)
    points = line[:, None] + np.einsum("ja,lai->lji", section.points, directors)
    cells = _cells(section, num_elements)
    chords = np.diff(line[::degree], axis=0)
    fibre = chords / np.linalg.norm(chords, axis=1, keepdims=True)
    layers = np.arange(points.shape[0] * per_layer).reshape(-1, per_layer)
    quads = np.arange(num_elements * per_element).reshape(-1, per_element)
    return SolidMesh(
        points=points.reshape(-1, 3),
        cells=cells,
        cell_part=np.zeros(len(cells), dtype=np.int64),
        fibre=np.repeat(fibre, per_element, axis=0),
        facets=_surfaces(section, quads),
        sweeps={0: Sweep(layers, section.points, line, directors, quads, section.weights())},
    )


def _cells(section: SectionMesh, num_elements: int) -> IntArray:
    """Nodes of each hexahedron, shape (num_elements num_quads, nodes_per_cell)."""
    degree, per_layer = section.degree, len(section.points)
    place = np.round(degree * HEXAHEDRA[degree].points).astype(np.int64)
    flat = np.round(degree * section.cell.points).astype(np.int64)
    in_quad = np.array([np.flatnonzero((flat == p[:2]).all(axis=1))[0] for p in place])
    one = section.quads[:, in_quad] + per_layer * place[:, 2]
    first = degree * per_layer * np.arange(num_elements)
    return np.asarray((first[:, None, None] + one).reshape(-1, len(place)))


def _surfaces(section: SectionMesh, cells: IntArray) -> dict[str, IntArray]:
    """Named surfaces of a swept part from the cells (num_elements, num_quads)."""
    hexahedron = HEXAHEDRA[section.degree]
    sides = [_facet(hexahedron, axis, value) for axis, value in ((1, 0), (0, 0), (0, 1), (1, 1))]
    surfaces = {}
    for tag, edges in (("lateral", section.outer), ("inner", section.inner)):
        if len(edges):
            cell = cells[:, edges[:, 0]].ravel()
            facet = np.tile(np.array(sides)[edges[:, 1]], len(cells))
            surfaces[tag] = np.stack([cell, facet], axis=1)
    for tag, end, value in (("start", 0, 0), ("end", -1, 1)):
        facet = np.full(cells.shape[1], _facet(hexahedron, 2, value))
        surfaces[tag] = np.stack([cells[end], facet], axis=1)
    return surfaces


def _facet(cell: ReferenceCell, axis: int, value: int) -> int:
    """Local facet where a coordinate of the reference cell has a value."""
    on = (cell.points[cell.facets][:, :, axis] == value).all(axis=1)
    return int(np.flatnonzero(on)[0])
