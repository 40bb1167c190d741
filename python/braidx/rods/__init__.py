"""Scenes of a few rods: cables, beams and solids of any shape, held, pulled, turned, in contact, at rest or in motion.

from braidx.rods import Beam, Rods, YarnMaterial, straight

steel = YarnMaterial.isotropic(modulus=200e3, poisson=0.3)
rods = Rods([Beam(straight((0, 0, 0), (100, 0, 0), 32), radius=1.0, material=steel)])
rods.clamp(0, 0)
rods.force(0, -1, (0.0, 50.0, 0.0))
rods.solve(increments=5)
print(rods.positions(0)[-1], rods.reaction(0, 0))
"""

from ..bodies import BeamSection, YarnMaterial
from .energy_balance import MotionStep
from .inertia import Scheme
from .path import NotConverged
from .rod import Beam, Cable, Rod, Solid
from .rigid import Cylinder, Plane, Sheave
from .rods import Rods
from .shapes import arc, curve, graded, helix, ring, straight

__all__ = [
    "Beam",
    "BeamSection",
    "Cable",
    "Cylinder",
    "MotionStep",
    "NotConverged",
    "Plane",
    "Rod",
    "Rods",
    "Scheme",
    "Sheave",
    "Solid",
    "YarnMaterial",
    "arc",
    "curve",
    "graded",
    "helix",
    "ring",
    "straight",
]
