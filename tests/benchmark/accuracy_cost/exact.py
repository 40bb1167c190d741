"""Scenes with an exact answer: those of tests/verification, with other meshes, models and solvers."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

VERIFICATION = Path(__file__).parents[2] / "verification"
for folder in ("contact", "rope", "solid"):
    sys.path.append(str(VERIFICATION / folder))

import test_bent_far as bar_case  # noqa: E402
import test_capstan as capstan_case  # noqa: E402
import test_strand as strand_case  # noqa: E402
import test_twisted_fibres as fibres_case  # noqa: E402
from bench import Values  # noqa: E402
from mpi4py import MPI  # noqa: E402
from tally import factors_of  # noqa: E402

from braidx.bodies import SolidBody  # noqa: E402
from braidx.meshing import round_section  # noqa: E402
from braidx.rods import Beam, Cable, Rods, YarnMaterial, straight  # noqa: E402

FRICTION, WRAP = 0.2, 180
LOOSE = 1e-3  # bundle factor of the beams that stand for a cable


def capstan(
    model: str = "cable",
    degree: int = 2,
    angle: float = 3.0,
    spacing: float | None = None,
    increments: int = 4,
    penetration: float | None = None,
    symmetrised: bool = False,
    solver: str = "",
    tolerance: float = 1e-7,
) -> Values:
    """C3 with a friction of 0.2 over half a turn; nodes are `angle` degrees apart, stations `spacing` of that."""

    def rod(line: Any) -> Cable | Beam:
        case = capstan_case
        if model == "cable":
            return Cable(line, case.THIN, case.STIFFNESS, case.TENSION, degree)
        modulus = case.STIFFNESS / (np.pi * case.THIN**2)
        material = YarnMaterial.isotropic(modulus, 0.0)
        return Beam(
            line,
            case.THIN,
            material,
            degree=degree,
            bundle_factor=LOOSE,
            tension=case.TENSION,
        )

    way = sum(capstan_case.WAYS)
    ways = capstan_case.WAYS if increments == 4 else (way / increments,) * increments
    options: dict[str, Any] = {"tolerance": tolerance}
    if spacing is not None:
        options["spacing"] = spacing * np.radians(angle) * capstan_case.RADIUS
    if (
        penetration is not None
    ):  # the penalty starts soft, and grows until rods are no deeper in each other
        options |= {"penalty": 10.0, "penetration": penetration}
    with factors_of(solver):
        rods, end = capstan_case.slide(FRICTION, WRAP, angle, rod, ways, symmetrised, **options)
        load = typical(loads_over_exact(rods, leverage(model)))
        ratio = capstan_case.ratio_of_tensions(rods, end)
    return {"T2 / T1": float(ratio), "line load": load}


def loads_over_exact(rods: Rods, lever: float, margin: float = 30.0) -> Any:
    """Line loads over those of Euler's formula at their places, T1 exp(mu theta) / R, but for degrees at either end."""
    contacts = rods.contacts()
    turned = np.arctan2(contacts["position"][:, 1], contacts["position"][:, 0])
    inside = (turned > np.radians(margin)) & (turned < np.radians(WRAP - margin))
    load = (contacts["normal_force"] / contacts["weight"])[inside]
    tension = capstan_case.TENSION * np.exp(FRICTION * lever * turned[inside])
    return load * (capstan_case.RADIUS + capstan_case.THIN) / tension


def leverage(model: str) -> float:
    """Arm of friction over that of the tension: friction of a beam acts on its surface, nearer to the drum's axis."""
    thick = capstan_case.RADIUS / (capstan_case.RADIUS + capstan_case.THIN)
    return thick if model == "beam" else 1.0


def typical(shares: Any) -> float:
    """One and the root mean square of what values over what they should be differ from it."""
    return float(1.0 + np.sqrt(np.mean((shares - 1.0) ** 2)))


def worst(shares: Any) -> float:
    """That one of values over what they should be which is farthest off."""
    return float(shares[np.argmax(np.abs(shares - 1.0))])


def capstan_exact(model: str = "cable", **options: Any) -> Values:
    """Euler's formula."""
    turned = FRICTION * np.radians(WRAP) * leverage(model)
    return {"T2 / T1": float(np.exp(turned)), "line load": 1.0}


def fibres(
    spans: int = 40, degree: int = 2, spacing: float | None = None, solver: str = ""
) -> Values:
    """C4: displacement of the middle, median and worst load per length, axial force."""
    step = fibres_case.LENGTH / spans
    options = {} if spacing is None else {"spacing": spacing * step}
    with factors_of(solver):
        rods = fibres_case.twisted(spans, degree, **options)
        contacts = rods.contacts()
        load = contacts["normal_force"] / contacts["weight"]
        force = abs(rods.reaction(0, 0)[0][2])
        middle = rods.positions(1)[spans // 2, 0] - fibres_case.OFFSET
    return {
        "displacement": float(middle),
        "load per length": float(np.median(load)),
        "worst load per length": fibres_case.LOAD * worst(load / fibres_case.LOAD),
        "axial force": float(force),
    }


def fibres_exact(**options: Any) -> Values:
    case = fibres_case
    return {
        "displacement": case.MIDDLE,
        "load per length": case.LOAD,
        "worst load per length": case.LOAD,
        "axial force": case.END_FORCE,
    }


STIFFNESSES = ("K11", "K12", "K21", "K22")


def strand(
    model: str = "cable",
    degree: int = 2,
    spans: int = 32,
    spacing: float | None = None,
    penalty: float | None = None,
    solver: str = "",
) -> Values:
    """R1: the stiffnesses of a strand of 1 + 6 wires over a lay of 80 mm, cut into `spans`."""
    options: dict[str, Any] = {"spans": spans, "degree": degree}
    if spacing is not None:
        options["spacing"] = spacing * strand_case.PITCH / spans
    if penalty is not None:
        options["penalty"] = penalty
    with factors_of(solver):
        found = strand_case.stiffness(model == "beam", **options)
    return dict(zip(STIFFNESSES, map(float, found.ravel()), strict=True))


def strand_exact(model: str = "cable", penalty: float | None = None, **options: Any) -> Values:
    """With the give of the case's own penalty; of wires that do not give way where another penalty is tried."""
    own = strand_case.PENALTY if penalty is None else 1e12
    found = strand_case.closed_form(float(model == "beam"), own)
    return dict(zip(STIFFNESSES, map(float, found.ravel()), strict=True))


def strand_depth(penalty: float) -> float:
    """Penetration of a strand's wires over their radius at the largest strain, -."""
    case = strand_case
    angle = np.arctan2(case.PITCH, 2 * np.pi * case.HELIX)
    tension = case.MODULUS * np.pi * case.WIRE**2 * case.STRAINS[-1] * np.sin(angle) ** 2
    return float(tension * np.cos(angle) ** 2 / case.HELIX / penalty / case.WIRE)


THICK = 0.05  # radius of the bar, mm


def bar(model: str = "beam", degree: int = 2, elements: int = 16, seeds: int = 8) -> Values:
    """A bar of 20 mm bent to a quarter of a circle by turning its end: the couple that it takes."""
    case, curvature = bar_case, 0.5 * np.pi / bar_case.LENGTH
    if model == "solid":
        section = round_section(THICK, seeds, degree=degree, equal_area=True)
        body = SolidBody(MPI.COMM_SELF, case.bar(section, elements), material=case.YARN)
        couple = float(case.turned_end(body, curvature)[1])
        free = body.num_unknowns - 3 * (2 * len(section.points) - 1)  # one end held, one rigid
        return {"couple": couple, "unknowns": free}
    line = straight((0, 0, 0), (0, 0, case.LENGTH), elements * degree)
    rods = Rods([Beam(line, THICK, case.YARN, degree=degree)], contact=False)
    rods.clamp(0, 0)
    rods.hold(0, -1, slice(3, 9))
    rods.move(0, -1, turn=(0.0, 0.5 * np.pi, 0.0))
    rods.solve(increments=4)
    return {"couple": float(abs(rods.reaction(0, 0)[1][1]))}


def bar_exact(**options: Any) -> Values:
    """E I kappa of the elastica, I of the circle."""
    inertia = 0.25 * np.pi * THICK**4
    return {"couple": bar_case.YARN.axial_modulus * inertia * 0.5 * np.pi / bar_case.LENGTH}
