"""Which share of a solid's energy is integrated where, and what is told about its stress.

Hexahedra of degree 1 lock: integrated in full they shear where they should curve, and hold the volume where they should
contract; with one Gauss point zigzags are free (hourglass). Each share of a law (hyperelastic.Split) therefore takes
points of its own. Where the third axis of the cells runs along the fibre:

    fibre's strain             2 x 2 x 2: varies linearly over the section, and contraction across is free in it
    shear along the fibre      2 x 2 x 1: torsion varies over the section; what varies along the cell is parasitic
    change of section's area   centre: no contraction is held up
    change of section's shape  1 - SECTION_SHARE at the centre, SECTION_SHARE at 2 x 2 x 2: no zigzag is free

Measured on slender bars, square with 1 to 16 cells in the section or round with 12 seeds, 5 or 20 cells along ten
widths, yarns and isotropic bars with nu up to 0.49: deflection under a load at the end 0.96 to 1.00 of Timoshenko's
(full integration: 0.28 to 0.99, least for 5 cells; the centre alone: mechanisms), twist of round bars within 0.2 %.
With the share of 0.5 a round section of 12 seeds that is squeezed to an ellipse yields 1.00 (o-grid) or 1.06 (wedge)
times what it should; with 0.1 it is 1.05 and 2.4.

Laws without a fibre take the change of volume at the centre, HOURGLASS of the change of shape at 2 x 2 x 2 and the rest
at 2 x 2 x 1 points where cells follow a line (deflection 0.96 to 1.07 with 2 cells or more over the bar) or else at the
centre, as do fibres across the cells (1.00 to 1.28, the most with 2). Degree 2 is integrated at all 27 points,
but at 3 x 3 x 2 the strain of fibres along cells and the shear along them, as bent cells are not stretched there (a bar
bent to a quarter of a circle, 8 cells six widths long, was 4 % too stiff with 27): deflection within 1 %, also for
nu = 0.49.
"""

from typing import Any, NamedTuple

import ufl

from .curve import Part
from .hyperelastic import Split, stress, von_mises

FULL = {1: 3, 2: 5}  # degree of quadrature with 2 or 3 Gauss points along each axis
SECTION_SHARE = 0.5  # of the section's change of shape that is integrated in full
HOURGLASS = 0.1  # likewise of the strain of laws without a fibre, and of cells that follow none

_LOW, _HIGH = 0.5 - 0.5 / 3.0**0.5, 0.5 + 0.5 / 3.0**0.5
_MIDDLE_POINTS = tuple((u, v, 0.5) for u in (_LOW, _HIGH) for v in (_LOW, _HIGH))


_THREE = ((0.5 - 0.5 * 0.6**0.5, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + 0.5 * 0.6**0.5, 5.0 / 18.0))
_COLUMNS = tuple(
    (u, v, w, a * b / 2.0) for u, a in _THREE for v, b in _THREE for w in (_LOW, _HIGH)
)


def along_cells(density: Any) -> Part:
    """Integrate at 3 x 3 x 2 Gauss points, two along the third axis of hexahedra."""
    return Part(density, 3, "custom", tuple(c[:3] for c in _COLUMNS), tuple(c[3] for c in _COLUMNS))


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
    if degree == 2 and (not swept or split.axial is None):
        return [Part(straining + split.volume, FULL[2])]
    if degree == 2:
        return [along_cells(split.axial + split.shear), Part(split.shape + split.volume, FULL[2])]
    if not swept:
        return [
            Part((1.0 - HOURGLASS) * straining + split.volume, 1),
            Part(HOURGLASS * straining, FULL[1]),
        ]
    if split.axial is None:
        return [
            Part(HOURGLASS * split.shape, FULL[1]),
            middle((1.0 - HOURGLASS) * split.shape),
            Part(split.volume, 1),
        ]
    return [
        Part(split.axial + SECTION_SHARE * split.shape, FULL[1]),
        middle(split.shear),
        Part((1.0 - SECTION_SHARE) * split.shape + split.volume, 1),
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
