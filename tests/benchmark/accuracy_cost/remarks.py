"""What the charts of scenes with an exact answer tell a user who has to choose; numbers are those of the results."""

from __future__ import annotations

from lookup import Lookup

Paragraphs = list[str]


def capstan(x: Lookup) -> Paragraphs:
    ratio = x.of("T2 / T1", angle=9.0)
    few, many = x.iterations(increments=1), x.iterations(increments=64)
    return [
        f"**Length of elements.** The ratio of tensions, a sum, is right to {ratio} with elements of 9°; the line "
        f"load, which is local, asks for more: {x.error(angle=9.0)} with 9°, {x.error(angle=6.0)} with 6°, "
        f"{x.error()} with 3°. Degree 2 does not pay on a drum ({x.error(degree=2)} with nodes 3° apart): loads on "
        "the nodes at ends and middles of its elements differ.",
        f"**What hardly matters.** The number of increments ({few} iterations for one, {many} for 64, with the same "
        "error: all of the cable slides in the end), the residual from 1e-3 down, and stations at half an element "
        "or closer. A penetration of 0.3 radii does no harm here, as the drum is large; one of 0.003 radii costs "
        f"accuracy ({x.error(penetration=0.003)}): loads of single places get uneven.",
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
        f"{x.error(**coarse)}, at the same cost. Only with 10 spans a turn, 36° each, is degree 1 ahead "
        f"({x.error(degree=1, spans=10)} against {x.error(spans=10)}).",
        f"**Worst place.** The load per length at its worst place is off by {x.of(worst)} with 40 spans of degree "
        f"2, and by {x.of(worst, **coarse)} with degree 1, though its median is right to "
        f"{x.of('load per length', **coarse)}: where a local load counts take degree 2, or look at more than one "
        "place.",
        "**Stations** as far apart as nodes would do; all linear solvers cost the same.",
    ]


def strand(x: Lookup) -> Paragraphs:
    return [
        "**Length of elements, degree.** With 8 spans a lay (45° each) stiffnesses of cables of degree 2 are off "
        f"by {x.error(spans=8, degree=2)}, with 16 by {x.error(spans=16, degree=2)}, with 32 by "
        f"{x.error(degree=2)}. Elements of degree 1 with the same nodes leave {x.error(spans=16)} and {x.error()}. "
        f"Too coarse is dear, too: 8 spans take {x.iterations(spans=8)} iterations, 32 of degree 2 take "
        f"{x.iterations(degree=2)}.",
        "**Penetration.** A penalty of 1000 N/mm² lets wires sink in by about 1 % of their radius at the largest "
        f"strain, and costs {x.error(degree=2, penalty=1e3)} of a stiffness (here against the closed form of wires "
        f"that do not give way): the helix shrinks. A tenth of that depth costs {x.error(degree=2, penalty=1e4)}. A "
        "strand about a core is as stiff as contact keeps its wires out: the depth allowed is the error in "
        "disguise, and a stiffer penalty takes no more iterations.",
        "**Penalties that adapt** are left out here: stiffnesses are differences of two loads, and a penalty that "
        "is raised between the two spoils them. Give `penalty` and `penetration=None` where results are "
        "subtracted.",
        "**Models.** The curvature that beams resist grows with their stretch, which leaves "
        f"{x.error(model='beam', degree=2)} on fine meshes; they take three times the unknowns of cables. Take them "
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
