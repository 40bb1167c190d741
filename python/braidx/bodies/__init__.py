"""Bodies: the unknowns, energy, forces and tangent of all yarns of one model."""

from .beam import BeamBody
from .body import CurveBody
from .cable import CableBody
from .section import BeamSection, YarnMaterial

__all__ = ["BeamBody", "BeamSection", "CableBody", "CurveBody", "YarnMaterial"]
