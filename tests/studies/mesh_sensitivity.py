"""Study E: seeds round solid yarns and elements along them.

    ./braidx shell python3 tests/studies/mesh_sensitivity.py

The sample is one pitch long and bent less than the demo's, so that yarns of solids from end to end stay affordable.
It is formed alike for all meshes.
"""

from study import QUICK, QUICK_MIXED, Case, Study, main

SHORT = (
    "rope.pitches=1",
    "yarn.model=solid",
    "steps.bend.travel=4",
    "steps.bend.increments=6",
)
MESHES = ((8, 36), (12, 36), (8, 72))  # seeds, elements per pitch: 1.4 and 0.7 mm long


def study(quick: bool = False) -> Study:
    meshes = ((8, 16), (12, 16)) if quick else MESHES
    labels = [f"{seeds} x {along}" for seeds, along in meshes]
    cases = [
        Case(label, float(i), (f"yarn.seeds={seeds}", f"yarn.solid_elements_per_pitch={along}"))
        for i, (label, (seeds, along)) in enumerate(zip(labels, meshes))
    ]
    return Study(
        name="mesh_sensitivity",
        title="E: mesh of solid yarns",
        quantity="seeds round a yarn x elements along a pitch",
        cases=tuple(cases),
        base=(*QUICK, *QUICK_MIXED) if quick else SHORT,
        chosen=(
            "The paper has 12 seeds round a yarn; its yarns' elements are said to be 0.3 mm long, which fits neither "
            "12 seeds nor this study. Errors are against the shortest elements."
        ),
        named=True,
        reference=labels[-1],
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
