"""Geometry of ropes before anything is computed: start configuration and stacking order."""

from braidx.geometry.checks import check_geometry
from braidx.geometry.crossings import Crossings
from braidx.geometry.rope import Rope, build_rope
from braidx.geometry.symmetry import Rotations, no_rotations, rotation_about_z, rotations

__all__ = [
    "Crossings",
    "Rope",
    "Rotations",
    "build_rope",
    "check_geometry",
    "no_rotations",
    "rotation_about_z",
    "rotations",
]
