"""Bodies: the unknowns, energy, forces and tangent of all yarns of one model."""

from ..meshing.beam_section import BeamSection
from .beam import BeamBody
from .body import CurveBody
from .cable import CableBody
from .solid import SolidBody
from .yarn_material import YarnMaterial

__all__ = ["BeamBody", "BeamSection", "CableBody", "CurveBody", "SolidBody", "YarnMaterial"]
