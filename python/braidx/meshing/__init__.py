"""Meshes of solids: swept along centre lines, or read from files."""

from .section import SectionMesh
from .solid_mesh import SolidMesh, Sweep, join
from .sweep import sweep
from .templates import rectangle, round_section

__all__ = ["SectionMesh", "SolidMesh", "Sweep", "join", "rectangle", "round_section", "sweep"]
