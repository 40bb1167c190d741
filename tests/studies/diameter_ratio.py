"""Study A of paper 2: the rope over sheaves of D/d 3.33 to 10.

./braidx shell python3 tests/studies/diameter_ratio.py
"""

from study import QUICK, Case, Statement, Study, main

ROPE = 12.0  # mm, the paper's diameter
STATEMENTS = (
    Statement("paper 2: slightly over 0.7 mm below D/d = 4", 0.7, (3.0, 4.0)),
    Statement("paper 2: falls as D/d rises"),
)


def study(quick: bool = False) -> Study:
    diameters, rope = ((20, 40), 5.6) if quick else ((40, 60, 80, 120), ROPE)
    cases = [
        Case(f"{diameter / rope:.2f}", diameter / rope, (f"sheave.diameter={diameter}",))
        for diameter in diameters
    ]
    return Study(
        name="diameter_ratio",
        title="A: diameter of the sheave over that of the rope",
        quantity="D/d (-)",
        cases=tuple(cases),
        statements=STATEMENTS,
        base=QUICK if quick else (),
        chosen="The ends are moved by 60 mm over every sheave, as over the smallest.",
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
