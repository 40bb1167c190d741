"""Geometry of ropes before anything is computed: start configuration and stacking order."""

from braidx.geometry.bending_checks import outer_diameter
from braidx.geometry.checks import check_geometry
from braidx.geometry.crossings import Crossings
from braidx.geometry.end_groups import axially_held, group_members
from braidx.geometry.overlap import largest_overlap
from braidx.geometry.rope import Rope, build_rope
from braidx.geometry.symmetry import (
    Rotations,
    goes_on,
    no_rotations,
    one_for_all,
    one_pitch,
    rotation_about_z,
    rotations,
)
from braidx.geometry.turns import angles_of, best_fit, cross_matrix, rates_of, rotation_of

__all__ = [
    "Crossings",
    "Rope",
    "Rotations",
    "angles_of",
    "axially_held",
    "best_fit",
    "build_rope",
    "check_geometry",
    "cross_matrix",
    "goes_on",
    "group_members",
    "largest_overlap",
    "no_rotations",
    "one_for_all",
    "one_pitch",
    "outer_diameter",
    "rates_of",
    "rotation_about_z",
    "rotation_of",
    "rotations",
]
