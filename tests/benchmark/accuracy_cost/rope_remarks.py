"""What the charts of ropes tell a user who has to choose; numbers are those of the results."""

from __future__ import annotations

from typing import Any

from bench import load
from lookup import Lookup
from scenes import (
    BENCHES,
    BENDING,
    CUTS,
    DEGREE,
    DEPTH,
    ELEMENTS,
    FACTORS,
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


def pulled(x: Lookup) -> Paragraphs:
    second, mumps, petsc = {DEGREE: 2, ELEMENTS: 20}, {FACTORS: "mumps"}, {FACTORS: "petsc"}
    return [
        "Numbers at points are elements per pitch.",
        "**Elements.** With cables of degree 1, 12 elements per pitch (1.5 from crossing to crossing) leave "
        f"{x.error(**{ELEMENTS: 12})}, 24 {x.error(**{ELEMENTS: 24})}, 40 {x.error()}, 80 "
        f"{x.error(**{ELEMENTS: 80})}. 20 of degree 2, which have the nodes of 40 of degree 1, leave "
        f"{x.error(**second)}. Beams need more: {x.error(**{MODEL: 'beam'})} with 40 of degree 1, "
        f"{x.error(**second, **{MODEL: 'beam'})} with 20 of degree 2.",
        f"**Penetration.** Deeper penetrations make a rope thinner and stiffer: {x.error(**{DEPTH: 0.05})} with "
        f"0.05 radii, {x.error()} with the default of 0.015, {x.error(**{DEPTH: 0.005})} with 0.005, for "
        f"{x.iterations(**{DEPTH: 0.05})}, {x.iterations()} and {x.iterations(**{DEPTH: 0.005})} iterations.",
        "**Increments, stations, residual** hardly matter. Strains of 0.4 % at a time leave "
        f"{x.error(**{STEP: 0.004})}, of 0.05 % {x.error(**{STEP: 0.0005})}; stations at every element "
        f"{x.error(**{CUTS: 1.0})}, ten per element {x.error(**{CUTS: 0.1})}; a residual of 1e-3 "
        f"{x.error(**{RESIDUAL: 1e-3})}, of 1e-6 {x.error(**{RESIDUAL: 1e-6})}.",
        f"**Tangent and factors.** Symmetrised: {x.iterations(**TANGENT)} iterations and {x.seconds(**TANGENT)} "
        f"instead of {x.iterations()} and {x.seconds()}; hardly anything slides here. MUMPS throughout takes "
        f"{x.seconds(**mumps)}, PETSc's own factors {x.seconds(**petsc)}. UMFPACK and SuperLU cannot be named in "
        "such a scene: forming has a symmetric tangent, for which they have no factors.",
        "**Too fine is no gain.** 40 elements of degree 2, nodes 0.45 mm or half a radius apart, did not come to "
        "rest at the default penetration, for want of a pairing that stays.",
    ]


def twelve(x: Lookup) -> Paragraphs:
    return [
        "Numbers at points are elements per pitch.",
        "**Elements.** This rope is more open than the one before, and pulled taut from a loose shape: 24 elements "
        f"of degree 1 (two from crossing to crossing) leave {x.error(**{ELEMENTS: 24})}, 36 "
        f"{x.error(**{ELEMENTS: 36})}, 60 {x.error(**{ELEMENTS: 60})}, 120 {x.error(**{ELEMENTS: 120})}; of degree "
        f"2 18 leave {x.error(**{DEGREE: 2, ELEMENTS: 18})}, 30 {x.error(**{DEGREE: 2, ELEMENTS: 30})}, 42 "
        f"{x.error(**{DEGREE: 2, ELEMENTS: 42})}.",
        f"**Penetration** of 0.005 radii leaves {x.error(**{ELEMENTS: 60, DEPTH: 0.005})} with 60 elements, in "
        f"{x.iterations(**{ELEMENTS: 60, DEPTH: 0.005})} iterations instead of {x.iterations(**{ELEMENTS: 60})}; "
        f"0.0015 with 42 of degree 2 {x.error(**{DEGREE: 2, ELEMENTS: 42}, **FINE)}, in "
        f"{x.iterations(**{DEGREE: 2, ELEMENTS: 42}, **FINE)}.",
    ]


def bent(x: Lookup) -> Paragraphs:
    deep, fine = {**TWELVE, DEPTH: 0.005}, {**TWELVE, **FINE}
    few, slack = {BENDING: 3}, {**QUICK, MODEL: "cable"}
    slid, second = "mean_relative_displacement", {**deep, DEGREE: 2}
    equals = [deep, {**deep, ELEMENTS: 80}, {**second, ELEMENTS: 20}, {**second, ELEMENTS: 48}]
    sliding = ", ".join(x.value(slid, **options) for options in equals)
    return [
        "Numbers at points are elements per pitch; all but the increments are compared in runs of twelve of them.",
        "**Penetration and elements go together.** At the default of 0.015 radii 16 elements per pitch leave "
        f"{x.error(**QUICK)}, 24 {x.error(**TWELVE, **{ELEMENTS: 24})}, 40 {x.error(**TWELVE)}; at 0.005 radii "
        f"{x.error(**QUICK, **{DEPTH: 0.005})}, {x.error(**TWELVE, **{ELEMENTS: 24, DEPTH: 0.005})}, "
        f"{x.error(**deep)}, and 80 {x.error(**deep, **{ELEMENTS: 80})}; 40 elements at 0.0015 radii "
        f"{x.error(**fine)}. A third of the penetration takes {x.iterations(**deep)} iterations instead of "
        f"{x.iterations(**TWELVE)}, a tenth {x.iterations(**fine)}.",
        f"**Degree 2** leaves {x.error(**second, **{ELEMENTS: 20})} with the nodes of 40 elements and "
        f"{x.error(**second, **{ELEMENTS: 48})} with 48 elements: no better than degree 1 for the same work.",
        "**Too fine is no gain.** 120 elements at 0.0015 radii, nodes a quarter of a radius apart, leave "
        f"{x.error(**fine, **{ELEMENTS: 120})}, 80 {x.error(**fine, **{ELEMENTS: 80})}: the finer rope is formed "
        f"into another shape, {x.value('outer_diameter_formed', **fine, **{ELEMENTS: 120})} instead of "
        f"{x.value('outer_diameter_formed', **fine, **{ELEMENTS: 80})} mm thick. Keep nodes a third of a radius "
        "apart or more.",
        f"**Sliding is the hard part.** The mean relative displacement of all crossings is {sliding} mm with 40 and "
        f"80 elements of degree 1 and 20 and 48 of degree 2 at 0.005 radii, and {x.value(slid, **TWELVE)} mm at the "
        "default: a seventh of a radius in a rope as short as this, and known to a tenth of itself. Shapes that "
        "the same rope is formed into differ by some tenths of a per cent of its diameter, and crossings remember "
        "that.",
        f"**Increments.** 6, 12 and 30 agree on the force ({x.error(**{BENDING: 6})}, {x.error(**TWELVE)}, "
        f"{x.error()}), not on friction work ({x.value('friction_work', **{BENDING: 6})}, "
        f"{x.value('friction_work', **TWELVE)}, {x.value('friction_work')} mJ). Three are too few, and dear: "
        f"{x.iterations(**few)} iterations (twelve: {x.iterations(**TWELVE)}), and the stabilisation does "
        f"{x.value('stabilisation_work_share', **few)} of the work.",
        f"**Stations** at every element leave {x.error(**TWELVE, **{CUTS: 1.0})} in "
        f"{x.iterations(**TWELVE, **{CUTS: 1.0})} iterations, ten per element {x.error(**TWELVE, **{CUTS: 0.1})} in "
        f"{x.iterations(**TWELVE, **{CUTS: 0.1})}, the default of four {x.iterations(**TWELVE)}.",
        "**Tangent and factors** (16 elements). Where yarns slide the consistent tangent is worth its price: "
        f"symmetrised {x.iterations(**QUICK, **TANGENT)} iterations and {x.seconds(**QUICK, **TANGENT)}, consistent "
        f"{x.iterations(**QUICK)} and {x.seconds(**QUICK)}. MUMPS in every iteration takes "
        f"{x.seconds(**QUICK, **{FACTORS: 'mumps'})}, PETSc's own factors "
        f"{x.seconds(**QUICK, **{FACTORS: 'petsc'})}; by default factors last for some iterations, and GMRES does "
        "the rest.",
        f"**Cables** that nothing pulls have no shape: their run ends at {x.value('end_force', **slack)} N instead "
        f"of {x.value('end_force', **QUICK)} N, held by the stabilisation alone, as the share of its work tells "
        f"({x.value('stabilisation_work_share', **slack)}, where it should stay below 0.01).",
    ]


def reasons() -> Paragraphs:
    """Why defaults that are not on the front stay what they are."""
    x = {bench.name: Lookup(bench, load(bench.name)) for bench in BENCHES}
    rope, sheave, strand, drum = x["pulled"], x["bent"], x["strand"], x["capstan"]
    second, deep = {DEGREE: 2, ELEMENTS: 20}, {**TWELVE, DEPTH: 0.005}
    return [
        "**Degree 1 of cables** stays. With the same nodes degree 2 is ahead in the strand "
        f"({strand.error(degree=2)} against {strand.error()}) and in the braid that is pulled "
        f"({rope.error(**second)} against {rope.error()}), behind on the drum ({drum.error(degree=2)} against "
        f"{drum.error()}) and in the braid that is bent ({sheave.error(**deep, **second)} against "
        f"{sheave.error(**deep)}, beams), and with twice the nodes the braid that is pulled did not come to rest "
        "with it. Beams of `braidx.rods` are of degree 2 by default, as bending asks for; those of scenes are bent "
        "in contact.",
        f"**A penetration of 0.015 radii** stays. 0.005 is better in the braid that is bent ({sheave.error(**deep)} "
        f"against {sheave.error(**TWELVE)}) at the same cost and in the one that is pulled "
        f"({rope.error(**{DEPTH: 0.005})} against {rope.error()}) for {rope.iterations(**{DEPTH: 0.005})} "
        f"iterations instead of {rope.iterations()}. But elements have to be fine enough: the rope of "
        "`demos/bending_over_sheave.toml`, with three of degree 1 from crossing to crossing, finds no shape with "
        "0.01 or 0.005 (no consistent pairing after 40 contact updates), and forms with 0.005 at once (65 "
        "iterations instead of 645) with six. `--accuracy` changes both together.",
        f"**Thirty increments of bending** stay: twelve do for the force, in {sheave.seconds(**TWELVE)} instead of "
        f"{sheave.seconds()}, but not for friction work (above).",
        "**Stations** four to an element, **increments** of pulling and **residual** stay: what others gain is a few "
        "iterations or what CPU times differ by from run to run.",
    ]


def models() -> str:
    """How far models differ where all of them are computed finely."""
    rope, sheave = (Lookup(b, load(b.name)) for b in BENCHES if b.name in ("pulled", "bent"))
    finest = {"cable": pulled_reference(), "beam": pulled_reference("beam")}
    lines = ["## Models are another question", ""]
    lines += [
        "What a yarn is modelled as is no matter of discretisation, so that `--accuracy` leaves it alone. Cables have",
        "rigid sections; those of beams give way where yarns press on each other, here with a modulus across of 2 GPa",
        "against 70 along.",
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
