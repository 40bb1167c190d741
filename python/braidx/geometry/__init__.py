"""Geometry of ropes before anything is computed: start configuration and stacking order."""

from braidx.geometry.checks import check_geometry
from braidx.geometry.crossings import Crossings
from braidx.geometry.rope import Rope, build_rope

__all__ = ["Crossings", "Rope", "build_rope", "check_geometry"]
