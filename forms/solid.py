"""Quadratures of solids: which share of the energy is integrated where.

Hexahedra of degree 1 lock in bending, as they shear where they should curve, and where volume is kept.
One Gauss point cures both and leaves zigzags free (hourglass). The shares of a law (hyperelastic.Split) therefore
take different points: ...
"""

from typing import Any

import ufl

from .curve import Part
from .hyperelastic import Split

HOURGLASS = 0.1
"""Share of full integration."""

_LOW, _HIGH = 0.5 - 0.5 / 3.0**0.5, 0.5 + 0.5 / 3.0**0.5
_MIDDLE_POINTS = tuple((u, v, 0.5) for u in (_LOW, _HIGH) for v in (_LOW, _HIGH))


def middle(density: Any) -> Part:
    """Integrate at 2 x 2 Gauss points in the middle of hexahedra along their third axis."""
    return Part(density, 1, "custom", _MIDDLE_POINTS, (0.25,) * 4)


def energy(split: Split, cell: str, degree: int, swept: bool) -> list[Part]:
    """Stored energy, with the quadrature of the cells.

    Args:
        split: Shares of the energy per reference volume, MPa.
        cell: "hexahedron" or "tetrahedron".
        degree: Degree of the cells, 1 or 2.
        swept: Whether the third axis of the hexahedra is along the fibre.
    """
    whole = split.axial + split.shear + split.bulk
    if cell == "tetrahedron":
        return [Part(whole, 1 if degree == 1 else 2)]
    if degree == 2:
        return [Part(whole, 5)]
    if not swept:
        return [Part((1.0 - HOURGLASS) * whole, 1), Part(HOURGLASS * whole, 3)]
    return [
        Part(split.axial + HOURGLASS * split.bulk, 3),
        middle(split.shear),
        Part((1.0 - HOURGLASS) * split.bulk, 1),
    ]


def deformation_gradient(position: Any) -> Any:
    """F of the current position, shape (3, 3)."""
    return ufl.grad(position)
