"""The scenes and the sweeps over what is chosen in each."""

from __future__ import annotations

from typing import Any

import exact
import ropes
from bench import Bench, Sweep

SOLVERS = (
    None,
    "umfpack",
    "superlu",
    "petsc",
)  # the tangent of friction is not symmetric: MUMPS by default
CHOLESKY = (None, "mumps", "petsc")  # CHOLMOD by default
BOTH = (None, "mumps", "petsc")  # of scenes that are formed, which takes Cholesky's factors
FACTORS = "solver__petsc__pc_factor_mat_solver_type"


def sweep(title: str, name: str, values: tuple[Any, ...], told: str = "{}", **base: Any) -> Sweep:
    """Runs that differ in one option; None is the scene's own value of it."""
    options = tuple({**base, **({} if value is None else {name: value})} for value in values)
    labels = tuple("default" if value is None else told.format(value) for value in values)
    return Sweep(title, options, labels, joined=not any(isinstance(v, (str, bool)) for v in values))


def capstan() -> Bench:
    angles = (18.0, 9.0, 6.0, None, 1.5, 0.75)
    return Bench(
        "capstan",
        "A cable round a cylinder",
        """C3: a cable slides half a turn round a cylinder, friction 0.2. Numbers at points are degrees between nodes.
        Error of the ratio of its tensions, and of its line load T / R (root mean square), against Euler's
        formula.""",
        exact.capstan,
        ("T2 / T1", "line load"),
        (
            sweep("cable, degree 1", "angle", (18.0, 9.0, 6.0, 3.0, 1.5, 0.75), "{:g}°", degree=1),
            sweep("cable, degree 2", "angle", angles, "{:g}°"),
            sweep(
                "beam, degree 1", "angle", (18.0, 6.0, 3.0, 1.5), "{:g}°", model="beam", degree=1
            ),
            sweep("beam, degree 2", "angle", (18.0, 6.0, None, 1.5), "{:g}°", model="beam"),
            sweep("station spacing", "spacing", (1.0, 0.5, 0.25, 0.1, 0.05), "{:g}"),
            sweep("increments", "increments", (1, 2, None, 16, 64)),
            sweep("penetration", "penetration", (0.3, 0.1, 0.03, 0.01, 0.003), "{:g} r"),
            sweep("tangent", "symmetrised", (None, True), "symmetric"),
            sweep("LU by", "solver", SOLVERS),
            sweep("residual", "tolerance", (1e-3, 1e-4, 1e-5, 1e-6, None, 1e-8), "{:g}"),
        ),
        exact.capstan_exact,
    )


def fibres() -> Bench:
    return Bench(
        "fibres",
        "Two twisted fibres",
        """C4: two stretched fibres are turned round each other once and become a double helix. Numbers at points are
        spans between nodes. Error of the axial force, of the place of the middle and of the load per length
        (median).""",
        exact.fibres,
        ("displacement", "load per length", "axial force"),
        (
            sweep("beam, degree 1", "spans", (10, 20, 40, 80, 160), degree=1),
            sweep("beam, degree 2", "spans", (10, 20, None, 80, 160)),
            sweep("station spacing", "spacing", (1.0, 0.5, 0.25, 0.1), "{:g}"),
            sweep("Cholesky by", "solver", CHOLESKY),
        ),
        exact.fibres_exact,
    )


def strand() -> Bench:
    spans, penalties = (4, 8, 16, None, 64), (1e2, 3e2, 1e3, 3e3, 1e4, 1e5, 1e6)
    penetrations = Sweep(
        "penetration",
        tuple({"penalty": penalty} for penalty in penalties),
        tuple(f"{exact.strand_depth(penalty):.1g} r" for penalty in penalties),
    )
    return Bench(
        "strand",
        "A strand of 1 + 6 wires",
        """R1: axial and torsional stiffness of a straight strand over one lay, against the closed form. Numbers at
        points are spans between nodes. Error of the worst of the four entries of its matrix.""",
        exact.strand,
        exact.STIFFNESSES,
        (
            sweep("cable, degree 1", "spans", (4, 8, 16, 32, 64), degree=1),
            sweep("cable, degree 2", "spans", spans),
            sweep("beam, degree 1", "spans", (8, 16, 32, 64), model="beam", degree=1),
            sweep("beam, degree 2", "spans", (8, 16, None, 64), model="beam"),
            sweep("station spacing", "spacing", (1.0, 0.5, 0.25, 0.1), "{:g}"),
            penetrations,
            sweep("Cholesky by", "solver", CHOLESKY),
        ),
        exact.strand_exact,
    )


def bar() -> Bench:
    return Bench(
        "bar",
        "A bar bent to a quarter of a circle",
        """A round bar whose end is turned by 90 degrees, without contact. Numbers at points are elements. Error of the
        couple that this takes, against E I κ of the slender bar. What is left on fine meshes, 0.01 to 0.1 %, is the
        thickness of this one.""",
        exact.bar,
        ("couple",),
        (
            sweep("beam, degree 1", "elements", (4, 8, 16, 32, 64), degree=1),
            sweep("beam, degree 2", "elements", (2, 4, 8, None, 32)),
            sweep("solid, degree 1", "elements", (8, None, 32, 64), model="solid", degree=1),
            sweep("solid, degree 2", "elements", (4, 8, None), model="solid"),
            sweep(
                "edges round, degree 1",
                "seeds",
                (4, None, 12, 16),
                elements=32,
                model="solid",
                degree=1,
            ),
        ),
        exact.bar_exact,
    )


FINE = {"contact__penetration_tolerance": 0.0015}  # of what stands for the exact answer
ELEMENTS, DEGREE, MODEL = "yarn__elements_per_pitch", "yarn__degree", "yarn__model"
CUTS, STEP = "contact__station_spacing", "steps__pull__strain_increment"
DEPTH, BENDING = "contact__penetration_tolerance", "steps__bend__increments"


def meshes(title: str, degree: int, counts: tuple[int | None, ...], **base: Any) -> Sweep:
    """Runs that differ in the elements per pitch; None is the scene's own mesh."""
    given = {DEGREE: degree, **base}
    options = tuple(base if count is None else {**given, ELEMENTS: count} for count in counts)
    return Sweep(title, options, tuple(str(count or "default") for count in counts))


def pulled_reference(yarn__model: str = "cable", **options: Any) -> dict[str, Any]:
    """The finest run of the same model."""
    if yarn__model == "beam":
        return {MODEL: "beam", DEGREE: 1, ELEMENTS: 80, DEPTH: 0.005}
    return {DEGREE: 2, ELEMENTS: 60, **FINE}


def pulled() -> Bench:
    return Bench(
        "pulled",
        "A braid that is pulled",
        """The rope of `demos/small_rope.toml`, eight yarns braided 1-over 1-under, eight crossings per pitch: formed,
        settled, pulled to 5 kN. Error of its axial stiffness and of its diameter when loaded, the larger of the
        two, against the finest run of the same model of yarns.""",
        ropes.computed("pulled"),
        ("rope_axial_stiffness", "outer_diameter_loaded"),
        (
            meshes("cable, degree 1", 1, (12, 16, 24, 40, 80, 120)),
            meshes("cable, degree 2", 2, (8, 12, 20, None, 28, 40)),
            meshes("beam, degree 1", 1, (16, 24, None, 60), **{MODEL: "beam"}),
            meshes("beam, degree 2", 2, (12, 20), **{MODEL: "beam"}),
            meshes("degree 1, 0.005 r deep", 1, (24, 40), **{DEPTH: 0.005}),
            meshes("degree 2, 0.005 r deep", 2, (12, 20, None, 28), **{DEPTH: 0.005}),
            meshes("degree 2, 0.0015 r deep", 2, (12, 20, None, 28), **FINE),
            sweep("station spacing", CUTS, (1.0, 0.5, None, 0.1)),
            sweep("penetration", DEPTH, (0.05, None, 0.005, 0.0015), "{:g} r"),
            sweep("increments of strain", STEP, (0.004, 0.002, None, 0.0005), "{:g}"),
            sweep("tangent", "solver__tangent", (None, "symmetric")),
            sweep("factors by", FACTORS, BOTH),
            sweep("residual", "solver__tolerance", (1e-3, 1e-4, None, 1e-6), "{:g}"),
        ),
        reference=pulled_reference,
    )


def twelve_reference(**options: Any) -> dict[str, Any]:
    """The finest run."""
    return {DEGREE: 2, ELEMENTS: 80, **FINE}


def twelve() -> Bench:
    return Bench(
        "twelve",
        "Paper 1's braid with single yarns",
        """Twelve yarns, 2-over 2-under, twelve crossings per pitch, formed, settled and pulled to the stress of the
        rope of 84 yarns at 70 kN. Error of its axial stiffness and of its diameter when loaded, the larger of the two,
        against the finest run.""",
        ropes.computed("twelve"),
        ("rope_axial_stiffness", "outer_diameter_loaded"),
        (
            meshes("cable, degree 1", 1, (24, 36, 60, 120)),
            meshes("cable, degree 2", 2, (18, 30, None, 42)),
            meshes("degree 1, 0.005 r deep", 1, (36, 60), **{DEPTH: 0.005}),
            meshes("degree 2, 0.005 r deep", 2, (30, None, 42), **{DEPTH: 0.005}),
            meshes("degree 2, 0.0015 r deep", 2, (30, None, 42), **FINE),
            sweep("station spacing", CUTS, (1.0, None)),
        ),
        reference=twelve_reference,
    )


TWELVE = {BENDING: 12}  # increments of runs that compare other things
DEEP = {**TWELVE, DEPTH: 0.015}
SHALLOW = {**TWELVE, DEPTH: 0.005}
QUICK = {**DEEP, DEGREE: 1, ELEMENTS: 16}
SOLID = {**QUICK, "yarn__seeds": 8}


def bent_reference(**options: Any) -> dict[str, Any]:
    """The finest run of beams, whatever is compared with it."""
    return {DEGREE: 2, ELEMENTS: 32, BENDING: 24, DEPTH: 0.0005}


def bent() -> Bench:
    mixed = {**SOLID, MODEL: "mixed", "yarn__solid_stretch": 10}
    solids = Sweep(
        "mixed and solid",
        (mixed, {**SOLID, MODEL: "solid"}),
        ("mixed", "solid"),
        joined=False,
    )
    return Bench(
        "bent",
        "A braid that is bent",
        """The smallest braid of the tests: four yarns about a core, two pitches of 17 mm, four crossings per pitch,
        formed and bent over a sheave of 20 mm by ends that travel by 3 mm, five radii of a yarn. Error of the force on
        an end against the finest run of beams.""",
        ropes.computed("bent"),
        ("end_force",),
        (
            meshes("degree 1, 0.015 r deep", 1, (16, 24, None), **DEEP),
            meshes("degree 1, 0.005 r deep", 1, (16, 24, None, 80), **SHALLOW),
            meshes("degree 1, 0.0015 r deep", 1, (None, 80, 120), **TWELVE, **FINE),
            meshes("degree 2, 0.015 r deep", 2, (12, 20), **DEEP),
            meshes("degree 2, 0.005 r deep", 2, (12, 20, 48), **SHALLOW),
            meshes("degree 2, 0.0015 r deep", 2, (12, 20), **TWELVE, **FINE),
            sweep("penetration", DEPTH, (0.05, 0.015, 0.005, 0.0015, 0.0005), "{:g} r", **TWELVE),
            sweep("cable", MODEL, ("cable",), **QUICK),
            sweep("increments", BENDING, (3, 6, 12, None)),
            sweep("station spacing", CUTS, (1.0, None, 0.1), **TWELVE),
            sweep("tangent", "solver__tangent", (None, "symmetric"), **QUICK),
            sweep("factors by", FACTORS, BOTH, **QUICK),
            sweep("residual", "solver__tolerance", (1e-3, None), "{:g}", **QUICK),
            solids,
        ),
        reference=bent_reference,
    )


BENCHES = (capstan(), fibres(), strand(), bar(), pulled(), twelve(), bent())
