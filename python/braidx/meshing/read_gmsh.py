"""Meshes of solids from gmsh, through its Python API."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .cells import Cells, Fibre, assemble, node_order, one_kind
from .reference import SOLID_CELLS, FloatArray, IntArray, ReferenceCell
from .solid_mesh import SolidMesh


def open_gmsh(path: Path, *, fibre: Fibre) -> SolidMesh:
    """Open a file in gmsh, mesh it if it is a model, and take its mesh; see read_mesh."""
    gmsh = _gmsh(f"reading {path.name}")
    started = bool(gmsh.isInitialized())
    if not started:
        gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    before = gmsh.model.getCurrent()
    try:
        gmsh.open(str(path))
        if path.suffix.lower() != ".msh":
            gmsh.model.mesh.generate(3)
        return from_gmsh(gmsh.model, fibre=fibre, source=str(path))
    finally:
        if started:
            gmsh.model.remove()
            gmsh.model.setCurrent(before)
        else:
            gmsh.finalize()


def from_gmsh(
    model: Any, *, fibre: Fibre = (0.0, 0.0, 1.0), source: str = "the gmsh model"
) -> SolidMesh:
    """Take the mesh of a gmsh model, of OpenCASCADE or any other.

    Args:
        model: `gmsh.model`, meshed.
        fibre: See read_mesh.
        source: Name of the mesh in messages.
    """
    tags, flat, _ = model.mesh.getNodes()
    points = np.asarray(flat, dtype=np.float64).reshape(-1, 3)
    number = np.full(int(np.max(tags, initial=0)) + 1, -1, dtype=np.int64)
    number[np.asarray(tags, dtype=np.int64)] = np.arange(len(tags))
    groups = model.getPhysicalGroups(3)
    volumes = [
        (tag, entity) for _, tag in groups for entity in model.getEntitiesForPhysicalGroup(3, tag)
    ]
    if not volumes:
        volumes = [(entity, entity) for _, entity in model.getEntities(3)]
    kind = one_kind(_kinds(model, volumes), source, _known(model))
    gmsh_type, reference = _known(model)[kind], _reference(model, _known(model)[kind])
    order = node_order(_their_points(model, gmsh_type), reference)
    pieces, parts = [], []
    for part, entity in volumes:
        _, flat_nodes = model.mesh.getElementsByType(gmsh_type, entity)
        cells = number[np.asarray(flat_nodes, dtype=np.int64)].reshape(-1, len(order))[:, order]
        pieces.append(cells)
        parts.append(np.full(len(cells), part))
    names = {tag: model.getPhysicalName(3, tag) for _, tag in groups}
    found = Cells(np.concatenate(pieces), np.concatenate(parts), names)
    return assemble(points, found, _surfaces(model, number), fibre)


def _surfaces(model: Any, number: IntArray) -> dict[str, IntArray]:
    """Vertices of the faces of each physical surface."""
    surfaces = {}
    for _, tag in model.getPhysicalGroups(2):
        faces: list[IntArray] = []
        for entity in model.getEntitiesForPhysicalGroup(2, tag):
            for kind, _, nodes in zip(*model.mesh.getElements(2, entity)):
                _, _, _, num_nodes, _, num_vertices = model.mesh.getElementProperties(kind)
                rows = np.asarray(nodes, dtype=np.int64).reshape(-1, num_nodes)
                faces.append(number[rows[:, :num_vertices]])
        if faces:
            surfaces[model.getPhysicalName(2, tag) or str(tag)] = np.concatenate(faces)
    return surfaces


def _kinds(model: Any, volumes: list[tuple[int, int]]) -> dict[str, int]:
    found: dict[str, int] = {}
    for _, entity in volumes:
        for kind, elements, _ in zip(*model.mesh.getElements(3, entity)):
            name = model.mesh.getElementProperties(kind)[0]
            found[name] = found.get(name, 0) + len(elements)
    return found


def _known(model: Any) -> dict[str, int]:
    """Type of each kind of cell that can be taken, by gmsh's name."""
    types = [
        model.mesh.getElementType(family, degree)
        for family in ("Tetrahedron", "Hexahedron")
        for degree in (1, 2)
    ]
    return {model.mesh.getElementProperties(kind)[0]: kind for kind in types}


def _reference(model: Any, gmsh_type: int) -> ReferenceCell:
    return SOLID_CELLS[model.mesh.getElementProperties(gmsh_type)[3]]


def _their_points(model: Any, gmsh_type: int) -> FloatArray:
    """Nodes in gmsh's order in our reference cell; gmsh's hexahedron is [-1, 1]^3."""
    _, dim, _, num_nodes, flat, _ = model.mesh.getElementProperties(gmsh_type)
    points = np.asarray(flat).reshape(num_nodes, dim)
    return points if SOLID_CELLS[num_nodes].is_simplex else 0.5 * (points + 1.0)


def _gmsh(purpose: str) -> Any:
    try:
        import gmsh
    except ImportError as error:
        raise ImportError(
            f"{purpose} needs gmsh: install it (Debian: python3-gmsh, conda: python-gmsh, pip: gmsh)"
        ) from error
    return gmsh
