"""Cells and facets as other programs name them, made a mesh of solids."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .reference import SOLID_CELLS, FloatArray, IntArray, ReferenceCell
from .solid_mesh import SolidMesh

Fibre = npt.ArrayLike | Callable[[FloatArray], FloatArray]


class Cells(NamedTuple):
    """Cells of one kind, with nodes in the order of basix."""

    cells: IntArray  # shape (n, num_nodes)
    part: IntArray  # number of the part, shape (n,), any integers
    names: dict[int, str]  # of parts that have one


def assemble(
    points: FloatArray,
    cells: Cells,
    surfaces: Mapping[str, IntArray],
    fibre: Fibre,
) -> SolidMesh:
    """A mesh of cells, and of surfaces given by the vertices of their facets, shape (n, 3 or 4) each.

    Nodes without a cell (of points, lines and surfaces of the model) are left out. Where a facet lies between two
    cells it is taken from the side of the lower one.
    """
    used, number = np.unique(cells.cells, return_inverse=True)
    renumbered = number.reshape(cells.cells.shape)
    parts, cell_part = np.unique(cells.part, return_inverse=True)
    reference = SOLID_CELLS[cells.cells.shape[1]]
    facets = {
        tag: _locate(tag, renumbered, np.searchsorted(used, faces), reference)
        for tag, faces in surfaces.items()
    }
    return SolidMesh(
        points=points[used],
        cells=renumbered,
        cell_part=cell_part.ravel(),
        fibre=_fibres(fibre, points[cells.cells].mean(axis=1)),
        facets=facets,
        part_names=tuple(cells.names.get(int(part), "") for part in parts),
    )


def one_kind(found: Mapping[str, int], source: str, known: Mapping[str, int]) -> str:
    """The one kind of volume cells in a mesh.

    Args:
        found: Number of cells of each kind.
        source: Name of the mesh, for messages.
        known: Kinds that can be taken.
    Raises:
        ValueError: If there is none, several, or one that is not known.
    """
    if not found:
        raise ValueError(f"{source} has no volume cells: mesh the volumes, and save them all")
    listed = ", ".join(f"{count} {kind}" for kind, count in sorted(found.items()))
    wrong = sorted(set(found) - set(known))
    if wrong:
        raise ValueError(
            f"{source} has {listed}: only hexahedra with 8 or 27 nodes and tetrahedra with 4 or 10 can be taken "
            "(gmsh: Mesh.SecondOrderIncomplete = 0)"
        )
    if len(found) > 1:
        raise ValueError(f"{source} has {listed}: one mesh takes one kind of cell")
    return next(iter(found))


def node_order(theirs: FloatArray, reference: ReferenceCell) -> IntArray:
    """Column of another program's cells for each node of the reference cell, from its nodes' coordinates there."""
    distance = np.linalg.norm(reference.points[:, None] - theirs[None], axis=2)
    order = distance.argmin(axis=1)
    assert np.all(distance.min(axis=1) < 1e-9) and len(set(order)) == len(theirs)
    return order


def _locate(tag: str, cells: IntArray, faces: IntArray, reference: ReferenceCell) -> IntArray:
    """(cell, local facet) of faces given by their vertices."""
    corners = 3 if reference.is_simplex else 4
    every = np.sort(cells[:, reference.facets[:, :corners]], axis=2).reshape(-1, corners)
    both = np.concatenate([every, np.sort(faces[:, :corners], axis=1)])
    _, first, number = np.unique(both, axis=0, return_index=True, return_inverse=True)
    place = first[number.ravel()[len(every) :]]
    if np.any(place >= len(every)):
        raise ValueError(
            f'surface "{tag}" has {np.count_nonzero(place >= len(every))} faces that bound no cell: '
            "mesh the volume that it belongs to"
        )
    return np.stack(np.divmod(place, len(reference.facets)), axis=1)


def _fibres(fibre: Fibre, centres: FloatArray) -> FloatArray:
    given: Any = fibre(centres) if callable(fibre) else fibre
    directions = np.asarray(given, dtype=np.float64)
    if directions.shape not in ((3,), centres.shape):
        raise ValueError(f"fibre has shape {directions.shape}: give (3,) or {centres.shape}")
    directions = np.broadcast_to(directions, centres.shape)
    lengths = np.linalg.norm(directions, axis=1, keepdims=True)
    if np.any(lengths == 0.0):
        raise ValueError("fibre has a zero vector: give directions")
    return directions / lengths
