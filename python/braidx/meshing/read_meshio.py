"""Meshes of solids from any file that meshio reads."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from .cells import Cells, Fibre, assemble, node_order, one_kind
from .reference import SOLID_CELLS, FloatArray, IntArray
from .solid_mesh import SolidMesh

# Vertices and groups of vertices whose middle is a node, in the order of meshio (that of VTK).
_HEX_VERTICES = (
    (0, 0, 0),
    (1, 0, 0),
    (1, 1, 0),
    (0, 1, 0),
    (0, 0, 1),
    (1, 0, 1),
    (1, 1, 1),
    (0, 1, 1),
)
_HEX_GROUPS = "01 12 23 30 45 56 67 74 04 15 26 37 0473 1265 0154 3762 0123 4567 01234567"
_TET_VERTICES = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
_TET_GROUPS = "01 12 02 03 13 23"
KINDS = {"hexahedron": 8, "hexahedron27": 27, "tetra": 4, "tetra10": 10}
TAGS = ("gmsh:physical", "medit:ref", "cell_tags", "part")


def from_meshio(path: Path, *, fibre: Fibre) -> SolidMesh:
    """Read a file with meshio; see read_mesh."""
    try:
        import meshio
    except ImportError as error:
        raise ImportError(
            f"reading {path.name} needs meshio: install it (Debian: python3-meshio, conda and pip: meshio)"
        ) from error
    mesh = meshio.read(path)
    found: dict[str, int] = {}
    for block in mesh.cells:
        if block.dim == 3:
            found[block.type] = found.get(block.type, 0) + len(block.data)
    kind = one_kind(found, str(path), KINDS)
    order = node_order(_their_points(kind), SOLID_CELLS[KINDS[kind]])
    groups = dict(_groups(mesh))
    pieces, parts, names = [], [], dict[int, str]()
    surfaces: dict[str, list[IntArray]] = {}
    for i, block in enumerate(mesh.cells):
        rows = np.asarray(block.data, dtype=np.int64)
        if block.type == kind:
            number, named = groups.get(i, (np.zeros(len(rows), dtype=np.int64), {}))
            pieces.append(rows[:, order])
            parts.append(number)
            names |= named
        elif block.dim == 2 and i in groups:
            number, named = groups[i]
            corners = 3 if block.type.startswith("triangle") else 4
            for value in np.unique(number[number >= 0]):
                faces = rows[number == value][:, :corners]
                surfaces.setdefault(named.get(int(value), str(value)), []).append(faces)
    return assemble(
        np.asarray(mesh.points, dtype=np.float64),
        Cells(np.concatenate(pieces), np.concatenate(parts), names),
        {tag: np.concatenate(faces) for tag, faces in surfaces.items()},
        fibre,
    )


def _groups(mesh: Any) -> Iterator[tuple[int, tuple[IntArray, dict[int, str]]]]:
    """Number of the group of each cell of a block (-1: none), and the groups' names, by block."""
    for i, block in enumerate(mesh.cells):
        for tag in TAGS:
            if tag in mesh.cell_data:
                number = np.asarray(mesh.cell_data[tag][i], dtype=np.int64)
                names = {int(v[0]): k for k, v in mesh.field_data.items() if v[1] == block.dim}
                yield i, (number, names)
                break
        else:
            number = np.full(len(block.data), -1, dtype=np.int64)
            names = dict[int, str]()
            for name, members in mesh.cell_sets.items():
                if members[i] is not None and len(members[i]):
                    names[len(names)] = name
                    number[np.asarray(members[i], dtype=np.int64)] = len(names) - 1
            if names:
                yield i, (number, names)


def _their_points(kind: str) -> FloatArray:
    """Nodes in meshio's order in the reference cell, shape (num_nodes, 3)."""
    hexahedron = kind.startswith("hexahedron")
    vertices = np.array(_HEX_VERTICES if hexahedron else _TET_VERTICES, dtype=float)
    if KINDS[kind] == len(vertices):
        return vertices
    groups = (_HEX_GROUPS if hexahedron else _TET_GROUPS).split()
    return np.vstack([vertices, [vertices[[int(d) for d in g]].mean(axis=0) for g in groups]])
