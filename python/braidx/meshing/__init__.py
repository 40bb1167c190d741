"""Meshes of solids: swept along centre lines, or read from files."""

from .read import read_mesh
from .read_gmsh import from_gmsh
from .section import SectionMesh
from .solid_mesh import SolidMesh, Sweep, join
from .sweep import sweep
from .templates import rectangle, round_section

__all__ = [
    "SectionMesh",
    "SolidMesh",
    "Sweep",
    "from_gmsh",
    "join",
    "read_mesh",
    "rectangle",
    "round_section",
    "sweep",
]
