"""Quadratures of solids: which share of the energy is integrated where.

Hexahedra of degree 1 lock in bending, as they shear where they should curve, and where volume is kept.
One Gauss point cures both and leaves zigzags free (hourglass). The shares of a law (hyperelastic.Split) therefore
take different points: ...
"""

from typing import Any, NamedTuple

import ufl

from .curve import Part
from .hyperelastic import Split, stress, von_mises

FULL = {1: 3, 2: 5}  # degree of quadrature with 2 or 3 Gauss points along each axis
HOURGLASS = 0.5
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
    straining = _straining(split)
    if cell == "tetrahedron":
        return [Part(straining + split.volume, degree)]
    if degree == 2:
        return [Part(straining + split.volume, FULL[2])]
    share = HOURGLASS
    if not swept:
        return [
            Part((1.0 - share) * straining + split.volume, 1),
            Part(share * straining, FULL[1]),
        ]
    if split.axial is not None:
        return [
            Part(split.axial + share * split.shape, FULL[1]),
            middle(split.shear),
            Part((1.0 - share) * split.shape + split.volume, 1),
        ]
    return [
        Part(share * split.shape, FULL[1]),
        middle((1.0 - share) * split.shape),
        Part(split.volume, 1),
    ]


class Measures(NamedTuple):
    """What is told about the stress at a point; each a scalar."""

    von_mises: Any  # of the Cauchy stress, MPa
    fibre_stress: Any  # Cauchy stress along the current fibre, MPa, positive when pulled
    axial_force: Any  # along the current fibre, per reference area across it, MPa
    energy: Any  # per reference volume, MPa
    volume: Any  # 1, so that its integral is the reference volume


def measures(gradient: Any, split: Split, fibre: Any) -> Measures:
    """Stress measures of a state.

    Args:
        gradient: F as a ufl.variable, shape (3, 3).
        split: Energy, a function of `gradient`.
        fibre: Unit direction at rest, shape (3,).
    """
    energy = _straining(split) + split.volume
    cauchy = stress(gradient, energy)
    moved = ufl.dot(gradient, fibre)
    along = moved / ufl.sqrt(ufl.dot(moved, moved))
    nominal = ufl.dot(ufl.diff(energy, gradient), fibre)
    return Measures(
        von_mises(cauchy),
        ufl.dot(along, ufl.dot(cauchy, along)),
        ufl.dot(nominal, along),
        energy,
        1.0,
    )


def best_points(density: Any, cell: str, degree: int) -> Part:
    """Integrate where stresses are most accurate: the Gauss points of one degree less."""
    return Part(density, degree if cell == "tetrahedron" else 2 * degree - 1)


def _straining(split: Split) -> Any:
    """All but the change of volume."""
    fibred = 0.0 if split.axial is None else split.axial + split.shear
    return split.shape + fibred
