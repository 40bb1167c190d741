"""What the charts of scenes with an exact answer tell a user who has to choose; numbers are those of the results."""

from __future__ import annotations

from lookup import Lookup

Paragraphs = list[str]


def capstan(x: Lookup) -> Paragraphs:
    ratio = x.of("T2 / T1", angle=9.0)
    few, many = x.iterations(increments=1), x.iterations(increments=64)
    straight = {"degree": 1, "angle": 3.0}
    return [
        f"**Length of elements.** The ratio of tensions, a sum, is right to {ratio} with nodes 9° apart; the line "
        f"load, which is local, asks for more: {x.error(angle=9.0)} with 9°, {x.error(angle=6.0)} with 6°, "
        f"{x.error()} with 3°, {x.error(angle=1.5)} with 1.5°.",
        f"**Degree.** Elements of degree 1 leave {x.error(degree=1, angle=6.0)} with 6°, {x.error(**straight)} with "
        f"3°, {x.error(degree=1, angle=1.5)} with 1.5°, at the same cost: degree 2 is ahead where nodes are near "
        "enough for either. Its stations on the drum stand at Gauss's points; in the middles of even cells, where "
        "they were before, they left 1.7 % with 3° and 4.1 % with 1.5°, and degree 2 did not pay here.",
        f"**What hardly matters.** The number of increments ({few} iterations for one, {many} for 64, with the same "
        "error: all of the cable slides in the end), the residual from 1e-4 down, stations "
        f"({x.error(spacing=1.0)} with two to an element, {x.error(spacing=0.05)} with twenty) and penetration: 0.3 "
        f"radii leave {x.error(penetration=0.3)}, as the drum is large, 0.1 {x.error(penetration=0.1)}, 0.003 "
        f"{x.error(penetration=0.003)} in {x.iterations(penetration=0.003)} iterations.",
        f"**Tangent and factors.** The symmetrised tangent takes {x.iterations(symmetrised=True)} iterations where "
        f"the consistent one takes {x.iterations()}, with the same result. MUMPS, UMFPACK, SuperLU and PETSc's own "
        "LU cost the same with so few unknowns.",
        "**Beams** are compared with Euler's formula for a rod that has a thickness: friction acts on its surface, "
        "nearer to the drum's axis by a radius, which takes 0.6 % off the ratio here. Beams need "
        f"{x.unknowns(model='beam')} unknowns and {x.seconds(model='beam')} where cables need {x.unknowns()} and "
        f"{x.seconds()}.",
    ]


def fibres(x: Lookup) -> Paragraphs:
    worst = "worst load per length"
    coarse = {"degree": 1, "spans": 40}
    return [
        f"**Degree.** With the same 40 spans between nodes, degree 2 has an error of {x.error()}, degree 1 of "
        f"{x.error(**coarse)}, at the same cost. With 10 spans a turn, 36° each, they have "
        f"{x.error(spans=10)} and {x.error(degree=1, spans=10)}.",
        f"**Worst place.** The load per length at its worst place is off by {x.of(worst)} with 40 spans of degree "
        f"2, and by {x.of(worst, **coarse)} with degree 1, though its median is right to "
        f"{x.of('load per length', **coarse)}: where a local load counts take degree 2, or look at more than one "
        "place.",
        "**Stations** as far apart as nodes would do; all linear solvers cost the same.",
    ]


def strand(x: Lookup) -> Paragraphs:
    return [
        "**Length of elements, degree.** With 8 spans a lay (45° each) stiffnesses of cables of degree 2 are off "
        f"by {x.error(spans=8)}, with 16 by {x.error(spans=16)}, with 32 by {x.error()}. Elements of degree 1 with "
        f"the same nodes leave {x.error(degree=1, spans=16)} and {x.error(degree=1, spans=32)}, and take "
        f"{x.iterations(degree=1, spans=32)} iterations with 32 instead of {x.iterations()}. Too coarse is dear, "
        f"too: 8 spans take {x.iterations(degree=1, spans=8)} iterations of degree 1, {x.iterations(spans=8)} of "
        "degree 2.",
        "**Penetration.** A penalty of 1000 N/mm² lets wires sink in by about 1 % of their radius at the largest "
        f"strain, and costs {x.error(penalty=1e3)} of a stiffness (here against the closed form of wires that do "
        f"not give way): the helix shrinks. A tenth of that depth costs {x.error(penalty=1e4)}. A strand about a "
        "core is as stiff as contact keeps its wires out: the depth allowed is the error in disguise, and a "
        "stiffer penalty hardly takes more iterations.",
        "**Stations** as far apart as nodes would do for stiffnesses of wires that touch all along "
        f"({x.error(spacing=1.0)}); local loads of cables of degree 2 want four times as many, the default. Between "
        "cables that lie along each other (C6, nodes that do not match) penetrations of single places were off by "
        "14 % with two to an element, by 1.5 % with eight, and are by less than 1 % with elements of degree 1.",
        "**Penalties that adapt** are left out here: stiffnesses are differences of two loads, and a penalty that "
        "is raised between the two spoils them. Give `penalty` and `penetration=None` where results are "
        "subtracted.",
        "**Models.** The curvature that beams resist grows with their stretch, which leaves "
        f"{x.error(model='beam')} on fine meshes; they take three times the unknowns of cables. Take them "
        "where bending and torsion of wires count: here they make nothing of the axial stiffness, and two thirds "
        "of the torsional one.",
    ]


def bar(x: Lookup) -> Paragraphs:
    thick, thin = {"model": "solid", "degree": 1, "elements": 32}, {"model": "solid", "elements": 8}
    return [
        f"**Degree.** Two beams of degree 2 bend to a quarter of a circle with an error of {x.error(elements=2)}, "
        f"four with {x.error(elements=4)}; of degree 1 it takes 16 for {x.error(degree=1, elements=16)} and 64 for "
        f"{x.error(degree=1, elements=64)}. Take degree 2 where bending counts.",
        f"**Solids** have to be divided finer: 16 elements of degree 1 leave {x.error(model='solid', degree=1)}, 64 "
        f"{x.error(model='solid', degree=1, elements=64)}; 8 of degree 2 {x.error(**thin)}, 16 "
        f"{x.error(model='solid')}. Of degree 1, 4 edges round the section leave {x.error(**thick, seeds=4)}, 8 "
        f"{x.error(**thick)}, 12 {x.error(**thick, seeds=12)}.",
        f"**Model.** For an error of {x.error(**thin)} solids have {x.unknowns(**thin)} unknowns, beams of degree 1 "
        f"{x.unknowns(degree=1, elements=16)} for {x.error(degree=1, elements=16)}: take solids for what happens "
        "within a section, not for bending. (Solids are solved by the iteration of the case here, which is not "
        "counted.)",
    ]
