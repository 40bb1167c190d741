"""Bodies: the unknowns, energy, forces and tangent of all yarns of one model."""

from .beam import BeamBody
from .body import CurveBody
from .cable import CableBody
from .section import BeamSection, YarnMaterial
from .solid import SolidBody

__all__ = ["BeamBody", "BeamSection", "CableBody", "CurveBody", "SolidBody", "YarnMaterial"]
