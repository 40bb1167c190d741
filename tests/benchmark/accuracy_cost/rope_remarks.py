"""What the charts of ropes tell a user who has to choose; numbers are those of the results."""

from __future__ import annotations

from typing import Any

from bench import load
from lookup import Lookup
from scenes import (
    BENCHES,
    BENDING,
    CUTS,
    DEEP,
    DEGREE,
    DEPTH,
    ELEMENTS,
    FACTORS,
    FINE,
    MODEL,
    QUICK,
    SHALLOW,
    SOLID,
    STEP,
    TWELVE,
    pulled_reference,
)

Paragraphs = list[str]
TANGENT = {"solver__tangent": "symmetric"}
RESIDUAL = "solver__tolerance"


def pulled(x: Lookup) -> Paragraphs:
    first, second = {DEGREE: 1}, {DEGREE: 2}
    mumps, petsc, beam = {FACTORS: "mumps"}, {FACTORS: "petsc"}, {MODEL: "beam"}
    return [
        "Numbers at points are elements per pitch.",
        "**Elements.** With cables of degree 1, 12 elements per pitch (1.5 from crossing to crossing) leave "
        f"{x.error(**first, **{ELEMENTS: 12})}, 24 {x.error(**first, **{ELEMENTS: 24})}, 40 "
        f"{x.error(**first, **{ELEMENTS: 40})}, 80 {x.error(**first, **{ELEMENTS: 80})}. Of degree 2, 12 leave "
        f"{x.error(**second, **{ELEMENTS: 12})}, 20 {x.error(**second, **{ELEMENTS: 20})}, 24 (three from crossing "
        f"to crossing, the default) {x.error()}, 28 {x.error(**second, **{ELEMENTS: 28})}. Beams need more: "
        f"{x.error(**beam)} with 40 of degree 1, {x.error(**beam, **second, **{ELEMENTS: 20})} with 20 of degree 2.",
        f"**Penetration.** Deeper penetrations make a rope thinner and stiffer: {x.error(**{DEPTH: 0.05})} with "
        f"0.05 radii, {x.error()} with the default of 0.015, {x.error(**{DEPTH: 0.005})} with 0.005, for "
        f"{x.iterations(**{DEPTH: 0.05})}, {x.iterations()} and {x.iterations(**{DEPTH: 0.005})} iterations. Below "
        "half a per cent errors do not fall any more with finer meshes and smaller depths, they scatter: the same "
        "rope is formed into shapes that differ by so much.",
        "**Increments, stations, residual** hardly matter. Strains of 0.4 % at a time leave "
        f"{x.error(**{STEP: 0.004})}, of 0.05 % {x.error(**{STEP: 0.0005})}; stations as far apart as nodes "
        f"{x.error(**{CUTS: 1.0})}, ten times as many {x.error(**{CUTS: 0.1})}; a residual of 1e-3 "
        f"{x.error(**{RESIDUAL: 1e-3})}, of 1e-6 {x.error(**{RESIDUAL: 1e-6})}.",
        f"**Tangent and factors.** Symmetrised: {x.iterations(**TANGENT)} iterations and {x.seconds(**TANGENT)} "
        f"instead of {x.iterations()} and {x.seconds()}; hardly anything slides here. MUMPS throughout takes "
        f"{x.seconds(**mumps)}, PETSc's own factors {x.seconds(**petsc)}. UMFPACK and SuperLU cannot be named in "
        "such a scene: forming has a symmetric tangent, for which they have no factors.",
        "**Too fine is no gain.** 40 elements of degree 2, nodes 0.45 mm or half a radius apart, did not come to "
        "rest at the default penetration, for want of a pairing that stays: the default keeps them two thirds of a "
        "radius apart.",
    ]


def twelve(x: Lookup) -> Paragraphs:
    first, second = {DEGREE: 1}, {DEGREE: 2}
    return [
        "Numbers at points are elements per pitch.",
        "**Elements.** This rope is more open than the one before, and pulled taut from a loose shape: 24 elements "
        f"of degree 1 (two from crossing to crossing) leave {x.error(**first, **{ELEMENTS: 24})}, 36 "
        f"{x.error(**first, **{ELEMENTS: 36})}, 60 {x.error(**first, **{ELEMENTS: 60})}, 120 "
        f"{x.error(**first, **{ELEMENTS: 120})}; of degree 2 18 leave {x.error(**second, **{ELEMENTS: 18})}, 30 "
        f"{x.error(**second, **{ELEMENTS: 30})}, 36 (three from crossing to crossing, the default) {x.error()}, 42 "
        f"{x.error(**second, **{ELEMENTS: 42})}.",
        f"**Penetration** of 0.005 radii leaves {x.error(**first, **{ELEMENTS: 60, DEPTH: 0.005})} with 60 elements "
        f"of degree 1, in {x.iterations(**first, **{ELEMENTS: 60, DEPTH: 0.005})} iterations instead of "
        f"{x.iterations(**first, **{ELEMENTS: 60})}, and {x.error(**{DEPTH: 0.005})} with 36 of degree 2, in "
        f"{x.iterations(**{DEPTH: 0.005})} instead of {x.iterations()}: no better. With 0.0015 radii degree 2 takes "
        f"{x.iterations(**FINE)} iterations, or does not come to an end (below).",
    ]


def bent(x: Lookup) -> Paragraphs:
    fine = {**TWELVE, **FINE}
    few, slack = {BENDING: 3}, {**QUICK, MODEL: "cable"}
    slid, second = "mean_relative_displacement", {**SHALLOW, DEGREE: 2}
    mesh = {DEGREE: 1}
    equals = [SHALLOW, {**SHALLOW, **mesh, ELEMENTS: 80}]
    equals += [{**second, ELEMENTS: 20}, {**second, ELEMENTS: 48}]
    sliding = ", ".join(x.value(slid, **options) for options in equals)
    return [
        "Numbers at points are elements per pitch; all but the increments are compared in runs of twelve of them.",
        "**Penetration and elements go together.** At 0.015 radii 16 elements per pitch leave "
        f"{x.error(**QUICK)}, 24 {x.error(**DEEP, **mesh, **{ELEMENTS: 24})}, 40 {x.error(**DEEP)}; at 0.005 radii, "
        "the default where there are six nodes or more from crossing to crossing, "
        f"{x.error(**SHALLOW, **mesh, **{ELEMENTS: 16})}, {x.error(**SHALLOW, **mesh, **{ELEMENTS: 24})}, "
        f"{x.error(**SHALLOW)}, and 80 {x.error(**SHALLOW, **mesh, **{ELEMENTS: 80})}; 40 elements at 0.0015 radii "
        f"{x.error(**fine)}. A third of the penetration takes {x.iterations(**SHALLOW)} iterations instead of "
        f"{x.iterations(**DEEP)}, a tenth {x.iterations(**fine)}.",
        f"**Degree 2** leaves {x.error(**second, **{ELEMENTS: 20})} with the nodes of 40 elements and "
        f"{x.error(**second, **{ELEMENTS: 48})} with 48 elements: no better than degree 1 for the same work.",
        "**Too fine is no gain.** 120 elements at 0.0015 radii, nodes a quarter of a radius apart, leave "
        f"{x.error(**fine, **mesh, **{ELEMENTS: 120})}, 80 {x.error(**fine, **mesh, **{ELEMENTS: 80})}: the finer "
        f"rope is formed into another shape, {x.value('outer_diameter_formed', **fine, **mesh, **{ELEMENTS: 120})} "
        f"instead of {x.value('outer_diameter_formed', **fine, **mesh, **{ELEMENTS: 80})} mm thick. Keep nodes a "
        "third of a radius apart or more.",
        f"**Sliding is the hard part.** The mean relative displacement of all crossings is {sliding} mm with 40 and "
        f"80 elements of degree 1 and 20 and 48 of degree 2 at 0.005 radii, and {x.value(slid, **DEEP)} mm with 40 "
        "at 0.015: a seventh of a radius in a rope as short as this, and known to a tenth of itself. Shapes that "
        "the same rope is formed into differ by some tenths of a per cent of its diameter, and crossings remember "
        "that.",
        f"**Increments.** 6, 12 and 30 agree on the force ({x.error(**{BENDING: 6})}, {x.error(**TWELVE)}, "
        f"{x.error()}), not on friction work ({x.value('friction_work', **{BENDING: 6})}, "
        f"{x.value('friction_work', **TWELVE)}, {x.value('friction_work')} mJ). Three are too few, and dear: "
        f"{x.iterations(**few)} iterations (twelve: {x.iterations(**TWELVE)}), and the stabilisation does "
        f"{x.value('stabilisation_residual_share', **few)} of the work.",
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
        f"({x.value('stabilisation_residual_share', **slack)}, where it should stay below 0.01).",
    ]


def reasons() -> Paragraphs:
    """Why the defaults are what they are, and why some stay that are not on the front."""
    x = {bench.name: Lookup(bench, load(bench.name)) for bench in BENCHES}
    rope, open_rope, sheave, strand, drum = (
        x[name] for name in ("pulled", "twelve", "bent", "strand", "capstan")
    )
    first, second = {DEGREE: 1}, {DEGREE: 2}
    coarse, many = {"degree": 1, "spans": 32}, {**first, ELEMENTS: 60}
    forty, curved = {**first, ELEMENTS: 40}, {**SHALLOW, DEGREE: 2, ELEMENTS: 20}
    return [
        f"**Degree 2 of cables.** With the same nodes it is ahead in the strand ({strand.error()} in "
        f"{strand.iterations()} iterations, degree 1 {strand.error(**coarse)} in {strand.iterations(**coarse)}) and "
        f"on the drum ({drum.error()} against {drum.error(degree=1, angle=3.0)}). In the braids that are pulled "
        f"three elements of it from crossing to crossing leave {rope.error()} and {open_rope.error()} in "
        f"{rope.iterations()} and {open_rope.iterations()} iterations, where five of degree 1 leave "
        f"{rope.error(**forty)} and {open_rope.error(**many)} in {rope.iterations(**forty)} and "
        f"{open_rope.iterations(**many)}. Scenes that state their elements, but no degree, keep degree 1, and with "
        f"it the number of their nodes. Beams that bend do no better with degree 2 ({sheave.error(**curved)} "
        f"against {sheave.error(**SHALLOW)} with the same nodes): those of scenes are of degree 1, those of "
        "`braidx.rods`, which have less contact and more bending, of degree 2.",
        "**But not of bundles.** Strands of several yarns, which lie along each other and are pressed together, are "
        "held up in forming, it seems by the kinks between elements of degree 2: the rope of 36 yarns "
        "(`tests/benchmark/scaling.py`) took 217 s of CPU time with 36 of them per pitch, 15 s with 40 of degree 1, "
        "and that of 84 yarns found no shape. They keep 40 of degree 1, and as many nodes of degree 1 where "
        "`--accuracy` has a row of degree 2.",
        "**Three elements from crossing to crossing.** Fewer are luck: two and a half leave "
        f"{rope.error(**second, **{ELEMENTS: 20})} in one rope, less than finer ones do, and "
        f"{open_rope.error(**second, **{ELEMENTS: 30})} in the other. Three and a half leave "
        f"{rope.error(**second, **{ELEMENTS: 28})} and {open_rope.error(**second, **{ELEMENTS: 42})}.",
        "**Penetrations of 0.005 radii in ropes that are bent**, where six nodes or more from crossing to crossing "
        f"let them be: {sheave.error(**SHALLOW)} instead of {sheave.error(**DEEP)} for "
        f"{sheave.iterations(**SHALLOW)} iterations instead of {sheave.iterations(**DEEP)}. With coarser elements "
        "0.015 radii: the rope of `demos/bending_over_sheave.toml`, with three of degree 1 from crossing to "
        "crossing, finds no shape with 0.01 or 0.005. Ropes that are pulled keep 0.015, too: 0.005 is no better "
        f"with the default's elements ({rope.error(**{DEPTH: 0.005})} against {rope.error()}, "
        f"{open_rope.error(**{DEPTH: 0.005})} against {open_rope.error()}), and takes up to twice the iterations.",
        f"**Thirty increments of bending** stay: twelve do for the force, in {sheave.seconds(**TWELVE)} instead of "
        f"{sheave.seconds()}, but not for friction work, which still falls from twelve to thirty (above). That is "
        "all that keeps the bent braid off the front of its force: of the runs with twelve, one is better than "
        "the default's mesh and penetration by as much as is counted here, and that one, 16 elements with "
        f"{sheave.error(**SHALLOW, **first, **{ELEMENTS: 16})}, is there by luck: 24 leave "
        f"{sheave.error(**SHALLOW, **first, **{ELEMENTS: 24})}.",
        "**Stations** four to a span between nodes, **increments** of pulling and **residual** stay: what others "
        "gain is a few iterations or what CPU times differ by from run to run. Errors of the twisted fibres below "
        "0.01 % differ by the places of stations, not by their number.",
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
