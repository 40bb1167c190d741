"""Study F: the yarns as beams, as solids about the crown and beams beyond, and as solids.

./braidx shell python3 tests/studies/models.py
"""

from study import QUICK, QUICK_MIXED, Case, Statement, Study, main

MODELS = {
    "beam": ("yarn.model=beam",),
    "mixed": ("yarn.model=mixed", "yarn.seeds=8", "yarn.solid_stretch=30"),
    "solid": ("yarn.model=solid", "yarn.seeds=8"),
}
QUICK_MODELS = {"beam": MODELS["beam"], "mixed": QUICK_MIXED}


def study(quick: bool = False) -> Study:
    # The tiny rope of solids from end to end takes minutes to come to rest between its clamps.
    models = QUICK_MODELS if quick else MODELS
    return Study(
        name="models",
        title="F: what the yarns are modelled as",
        quantity="model of the yarns",
        cases=tuple(Case(m, float(i), words) for i, (m, words) in enumerate(models.items())),
        statements=(
            Statement("paper 2, with solids: slightly over 0.7 mm below D/d = 4", 0.7, (1.5, 2.5)),
        ),
        base=QUICK if quick else (),
        chosen="All models are of one yarn: the same moduli, section and nodes along it. Errors are against the last.",
        named=True,
        reference=list(models)[-1],
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
