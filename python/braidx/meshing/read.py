"""Meshes of solids from files."""

from __future__ import annotations

from pathlib import Path

from .cells import Fibre
from .read_gmsh import open_gmsh
from .read_meshio import from_meshio
from .solid_mesh import SolidMesh

GMSH_FILES = {".geo", ".msh", ".step", ".stp", ".brep", ".iges", ".igs"}


def read_mesh(path: str | Path, *, fibre: Fibre = (0.0, 0.0, 1.0)) -> SolidMesh:
    """Read hexahedra or tetrahedra of degree 1 or 2.

    `.geo` models are meshed, as are the CAD files that gmsh opens; `.msh` and these are read by gmsh, everything else
    by meshio. Physical volumes (gmsh) or cell sets become parts, physical surfaces or sets of faces named surfaces.
    Lengths are in mm.

    Args:
        path: File.
        fibre: Direction of the fibres: one, one per cell, or a function of the cells' centres (num_cells, 3).
    Raises:
        ValueError: If the file is missing or has no cells, or cells of several kinds.
        ImportError: If gmsh or meshio is needed and not installed.
    """
    path = Path(path)
    if not path.is_file():
        raise ValueError(f"{path}: there is no such file")
    if path.suffix.lower() not in GMSH_FILES:
        return from_meshio(path, fibre=fibre)
    return open_gmsh(path, fibre=fibre)
