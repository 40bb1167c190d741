"""Study B of paper 2: braids of 30, 45 and 60 degrees from the horizontal.

./braidx shell python3 tests/studies/braiding_angle.py
"""

from study import QUICK, Case, Statement, Study, main, yarn_of

# Pitches by angle, so that all ropes are 174 to 176 mm long, and elements per pitch, 1.2 to 1.6 mm along the yarn.
ROPES = {30: (12, 24), 45: (7, 24), 60: (4, 32)}
QUICK_ROPES = {45: (3, 16), 60: (2, 16)}
YARNS = ("braid.strands_per_direction=[4, 4]", *yarn_of(0.8, 40.2e3))  # 20 GPa, as in the demo


def study(quick: bool = False) -> Study:
    ropes = QUICK_ROPES if quick else ROPES
    cases = [
        Case(
            f"{angle}",
            float(angle),
            (
                f"braid.angle={angle}",
                f"rope.pitches={pitches}",
                f"yarn.elements_per_pitch={elements}",
            ),
        )
        for angle, (pitches, elements) in ropes.items()
    ]
    return Study(
        name="braiding_angle",
        title="B: braiding angle",
        quantity="braiding angle from the horizontal (degrees)",
        cases=tuple(cases),
        statements=(
            Statement("paper 2: less than 0.3 mm at 30 degrees", 0.3, (27.0, 33.0)),
            Statement("paper 2: three times that at 60", 0.9, (57.0, 63.0)),
            Statement("paper 2: grows rapidly above 45 degrees"),
        ),
        base=QUICK if quick else YARNS,
        chosen=(
            "The paper does not state the yarns of this group. The demo's 12 yarns of radius 1 mm on helices of 4 mm "
            "find no shape without penetration at 30 and 45 degrees: at 45 the yarns cross at right angles every "
            "2.96 mm, and a plain weave of them needs sqrt(3) times their diameter, 3.46 mm. Chosen for all angles: 8 "
            "yarns of radius 0.8 mm and of the demo's moduli, on the same helices, the core as it follows, 2.4 mm."
        ),
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
