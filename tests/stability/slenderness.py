"""(d) A cantilever bent by P L^2 / EI = 10, and one rolled up by a couple, against slenderness and increments."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from braidx.rods import Beam, Rods, YarnMaterial, straight
from family import Family
from judge import CONVERGED, WRONG, Outcome, Watch

LENGTH, MODULUS = 1000.0, 1000.0  # mm, MPa
ELEMENTS = 32
# Deflection and shortening over the length of an elastica: Mattiasson, Numerical results from large deflection beam
# and frame problems analysed by means of elliptic integrals (1981).
ELASTICA = (0.81061, 0.55500)
EXACT = 2e-3  # of the length; thick beams may differ by the square of their strains


def cantilever(slenderness: float, elements: int = ELEMENTS) -> tuple[Rods, float]:
    """A cantilever along x, and its stiffness in bending, N mm^2."""
    radius = LENGTH / slenderness
    line = straight((0, 0, 0), (LENGTH, 0, 0), 2 * elements)
    rods = Rods([Beam(line, radius, YarnMaterial.isotropic(MODULUS, 0.3))])
    rods.clamp(0, 0)
    return rods, MODULUS * np.pi * radius**4 / 4.0


def judged(watch: Watch, case: tuple[float, float], exact: tuple[float, float]) -> Outcome:
    """With the distance of the tip from where an elastica has it, over the length."""
    tip = watch.rods.positions(0)[-1] / LENGTH
    error = float(np.hypot(tip[1] - exact[0], tip[0] - exact[1]))
    found = watch.outcome(*case, error=error)
    if found.status == CONVERGED and error > EXACT + (2.0 * np.pi / case[0]) ** 2:
        return replace(found, status=WRONG, why=f"the tip is off by {error:.2g} of the length")
    return found


def bent(
    slenderness: float,
    increments: float,
    elements: int = ELEMENTS,
    case: tuple[float, float] | None = None,
) -> Outcome:
    """A dead force across the tip; named by slenderness and increments unless by `case`."""
    rods, bending = cantilever(slenderness, elements)
    watch = Watch(rods)
    rods.force(0, -1, (0.0, 10.0 * bending / LENGTH**2, 0.0))
    watch.solve(int(increments))
    return judged(watch, case or (slenderness, increments), (ELASTICA[0], 1.0 - ELASTICA[1]))


def rolled(slenderness: float, increments: float) -> Outcome:
    """A couple at the tip that bends the cantilever to a ring."""
    rods, bending = cantilever(slenderness)
    watch = Watch(rods)
    rods.couple(0, -1, (0.0, 0.0, 2.0 * np.pi * bending / LENGTH))
    watch.solve(int(increments))
    return judged(watch, (slenderness, increments), (0.0, 0.0))


SLENDERNESS = (10.0, 30.0, 1e2, 1e3, 1e4, 1e5)
BENT = Family(
    "bent",
    "Slenderness: a cantilever bent by a force",
    ("length over radius", "increments"),
    (SLENDERNESS, (1.0, 3.0, 10.0, 30.0)),
    bent,
    "A cantilever of 32 elements is bent by a dead force of P L²/EI = 10 across its tip. From a slenderness of 100 on "
    "its tip has to be where an elastica has it, within 0.2 % of the length.",
    means=(
        "Slender beams cost nothing extra: a slenderness of 1e5 takes a third more iterations than 100, also in "
        "a single increment. Elements may be thousands of radii long. Before, sections contracting by the axial strain "
        "locked all beams of more than 300 radii per element, and iterations strayed (theory)."
    ),
)
ROLLED = Family(
    "rolled",
    "Slenderness: a cantilever rolled up by a couple",
    ("length over radius", "increments"),
    (SLENDERNESS, (1.0, 3.0, 10.0, 30.0)),
    rolled,
    "The same cantilever is rolled up to a ring by a couple of 2 π EI/L; its tip has to come back to the clamp.",
    means=(
        "As above. Beams of slenderness 10, rolled up to 1.6 radii, stop at 79 % with a message. Large increments may "
        "end with an element turned inside out; these are found and cut. The work of couples is judged only where "
        "sections turn by little in each increment."
    ),
)
