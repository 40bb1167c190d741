"""What the charts of ropes tell a user who has to choose; numbers are those of the results."""

from __future__ import annotations

from typing import Any

from bench import load
from lookup import Lookup
from scenes import (
    BENCHES,
    CUTS,
    DEGREE,
    DEPTH,
    ELEMENTS,
    FINE,
    MODEL,
    QUICK,
    SOLID,
    STEP,
    TWELVE,
    pulled_reference,
)

Paragraphs = list[str]
TANGENT = {"solver__tangent": "symmetric"}
RESIDUAL = "solver__tolerance"


def factors(name: str) -> dict[str, Any]:
    """Options of a run whose linear systems are factorised by a package."""
    return {"solver__petsc__pc_factor_mat_solver_type": name}


def pulled(x: Lookup) -> Paragraphs:
    second = {DEGREE: 2, ELEMENTS: 20}
    return [
        f"**Elements.** With cables of degree 1, 12 elements per pitch (1.5 from crossing to crossing) leave "
        f"{x.error(**{ELEMENTS: 12})}, 24 {x.error(**{ELEMENTS: 24})}, 40 {x.error()}, 80 "
        f"{x.error(**{ELEMENTS: 80})}. "
        f"20 of degree 2, which have the nodes of 40 of degree 1, leave {x.error(**second)} in {x.seconds(**second)} "
        f"instead of {x.seconds()}: half-way nodes follow the bends over crossings.",
        f"**Penetration.** Deeper penetrations make a rope thinner and stiffer: {x.error(**{DEPTH: 0.05})} with "
        f"0.05 radii, "
        f"{x.error()} with the default of 0.015, {x.error(**{DEPTH: 0.005})} with 0.005, for "
        f"{x.iterations(**{DEPTH: 0.05})}, "
        f"{x.iterations()} and {x.iterations(**{DEPTH: 0.005})} iterations.",
        f"**Increments, stations, residual.** Strains of 0.4 % at a time leave {x.error(**{STEP: 0.004})}, of 0.05 % "
        f"{x.error(**{STEP: 0.0005})}; stations at every element {x.error(**{CUTS: 1.0})}, ten per element "
        f"{x.error(**{CUTS: 0.1})}; a residual of 1e-3 {x.error(**{RESIDUAL: 1e-3})}, of 1e-6 "
        f"{x.error(**{RESIDUAL: 1e-6})}.",
        f"**Tangent and factors.** Symmetrised: {x.iterations(**TANGENT)} iterations and {x.seconds(**TANGENT)} "
        f"instead of "
        f"{x.iterations()} and {x.seconds()}. UMFPACK takes {x.seconds(**factors('umfpack'))}, SuperLU "
        f"{x.seconds(**factors('superlu'))}, PETSc's LU {x.seconds(**factors('petsc'))}: systems of some "
        f"hundred unknowns do "
        "not tell them apart.",
        "**Nodes closer than half a radius** of the yarn are no gain: 40 elements of degree 2, nodes 0.45 mm "
        "apart, did not come "
        "to rest. Contact elements that are short beside the yarn's thickness find another pairing in every update.",
    ]


def bent(x: Lookup) -> Paragraphs:
    deep, fine = {**TWELVE, DEPTH: 0.005}, {**TWELVE, **FINE}
    few = {"steps__bend__increments": 3}
    mean = "mean_relative_displacement"
    return [
        f"**Penetration** decides. The default of 0.015 radii leaves {x.error(**TWELVE)}, 0.05 "
        f"{x.error(**TWELVE, **{DEPTH: 0.05})}, "
        f"0.005 {x.error(**deep)}, 0.0015 {x.error(**fine)}, for {x.iterations(**TWELVE)}, "
        f"{x.iterations(**TWELVE, **{DEPTH: 0.05})}, {x.iterations(**deep)} and {x.iterations(**fine)} "
        f"iterations. The force "
        f"on an end is less sensitive ({x.of('end_force', **TWELVE)} at the default) than the sliding of crossings "
        f"({x.of(mean, **TWELVE)}), which is itself only ten times as large as those penetrations in a rope as "
        f"short as this.",
        f"**Elements.** 16 per pitch (four from crossing to crossing) leave {x.error(**QUICK)}, 24 "
        f"{x.error(**TWELVE, **{ELEMENTS: 24})}, 40 {x.error(**TWELVE)} with the default penetration, where no "
        f"mesh helps; with 0.005 "
        f"radii 16 leave {x.error(**QUICK, **{DEPTH: 0.005})}, 24 "
        f"{x.error(**TWELVE, **{ELEMENTS: 24, DEPTH: 0.005})}, and 40 "
        f"{x.error(**deep)}.",
        f"**Increments** do not change forces and sliding (three: {x.error(**few)}, 30: {x.error()}), but "
        f"friction work "
        f"({x.value('friction_work', **few)} and {x.value('friction_work')} mJ); and too few are dear: "
        f"{x.iterations(**few)} "
        f"iterations for three, {x.iterations(**TWELVE)} for twelve.",
        f"**Tangent and factors** (16 elements). Symmetrised: {x.iterations(**QUICK, **TANGENT)} iterations and "
        f"{x.seconds(**QUICK, **TANGENT)} instead of {x.iterations(**QUICK)} and {x.seconds(**QUICK)}. MUMPS in "
        f"every iteration takes "
        f"{x.seconds(**QUICK, **factors('mumps'))}, SuperLU {x.seconds(**QUICK, **factors('superlu'))}; the "
        f"default keeps the "
        "factors for some iterations and lets GMRES do the rest.",
        f"**Models.** Cables that nothing pulls have no shape: their run ends at "
        f"{x.value('end_force', **QUICK, **{MODEL: 'cable'})} N "
        f"instead of {x.value('end_force', **QUICK)} N, held by the stabilisation alone, which the share of its "
        f"work tells "
        f"({x.value('stabilisation_work_share', **QUICK, **{MODEL: 'cable'})}; a run should stay below 0.01).",
    ]


def models() -> str:
    """How far models differ where all of them are computed finely."""
    rope, sheave = (Lookup(b, load(b.name)) for b in BENCHES if b.name in ("pulled", "bent"))
    finest = {"cable": pulled_reference(), "beam": pulled_reference("beam")}
    lines = ["## Models are another question", ""]
    lines += [
        "What a yarn is modelled as is no matter of discretisation, so that no error in per cent can be given "
        "for it, and "
        "`--accuracy` leaves it alone.",
        "",
        "| rope | model | result | unknowns | CPU time (s) |",
        "| --- | --- | --- | ---: | ---: |",
    ]
    for name, options in finest.items():
        value = rope.value("rope_axial_stiffness", **options)
        lines.append(_row("pulled, finest", name, f"{value} kN", rope, options))
    for name in ("beam", "mixed", "solid"):
        options = dict(QUICK) if name == "beam" else {**SOLID, MODEL: name}
        options |= {"yarn__solid_stretch": 10} if name == "mixed" else {}
        force = sheave.value("end_force", **options)
        slid = sheave.value("mean_relative_displacement", **options)
        lines.append(_row("bent, 16 elements", name, f"{force} N, {slid} mm", sheave, options))
    return "\n".join([*lines, ""])


def _row(rope: str, model: str, result: str, x: Lookup, options: dict[str, Any]) -> str:
    cost = f"{x.unknowns(**options)} | {x.seconds(**options).removesuffix(' s')}"
    return f"| {rope} | {model} | {result} | {cost} |"
