"""What slender rods do, exactly: references that beams and solids share, and how they are read off a scene."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from braidx.rods import Rods, arc

Floats = npt.NDArray[np.float64]

# Load P L^2 / EI on a cantilever: shortening / L, deflection / L, angle of the tip; of the inextensible elastica
# (elliptic integrals).
ELASTICA = {
    1.0: (0.0564332, 0.3017208, 0.4613519),
    2.0: (0.1606417, 0.4934575, 0.7817498),
    5.0: (0.3876284, 0.7137915, 1.2153681),
    10.0: (0.5549956, 0.8106090, 1.4302855),
}
# Displacement of the tip of an arc of 45 degrees, square section of side 1, under a dead load of 600 out of its plane:
# of the shear-deformable rod, integrated as a boundary value problem of ordinary differential equations.
ARC_RADIUS, ARC_ANGLE, ARC_TIP = 100.0, np.pi / 4.0, np.array([-23.56024, -13.60452, 53.47486])


def tip_of(rods: Rods, length: float = 1.0) -> tuple[float, float, float]:
    """Of a cantilever along x that is bent in the plane (x, y), as in ELASTICA."""
    (x, y, _), ((along, across, _), _) = rods.positions(0)[-1], rods.directors(0)[-1]
    return 1.0 - x / length, y / length, float(np.arctan2(-along, across))


def circle(s: Floats, radius: float) -> Floats:
    """Position at arc length s of a rod rolled up from the x axis towards y, shape (len(s), 2)."""
    return np.asarray(radius * np.stack([np.sin(s / radius), 1.0 - np.cos(s / radius)], axis=1))


def arc_of_45_degrees(num_spans: int) -> tuple[Floats, Floats]:
    """Nodes, from the origin along x, towards y, and directors inward and along z; shapes (n, 3), (n, 2, 3)."""
    line = arc(ARC_RADIUS, ARC_ANGLE, num_spans)
    turn = np.linspace(0.0, ARC_ANGLE, len(line))
    inward = np.stack([-np.sin(turn), np.cos(turn), 0.0 * turn], axis=1)
    return line, np.stack([inward, np.tile([0.0, 0.0, 1.0], (len(line), 1))], axis=1)
