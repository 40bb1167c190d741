"""Study D of paper 2: yarns of radius 0.8, 0.9 and 1.0 mm.

./braidx shell python3 tests/studies/yarn_radius.py
"""

import math

from study import QUICK, Case, Statement, Study, main, yarn_of

MODULUS = 62.8e3 / math.pi  # MPa, along the yarns of the demo


def study(quick: bool = False) -> Study:
    radii, helix_radius = ((0.5, 0.6), 1.6) if quick else ((0.8, 0.9, 1.0), 4.0)
    return Study(
        name="yarn_radius",
        title="D: radius of the yarns",
        quantity="radius of the yarns (mm)",
        cases=tuple(
            Case(f"{r:g}", r, yarn_of(r, MODULUS * math.pi * r**2, helix_radius)) for r in radii
        ),
        statements=(
            Statement("paper 2: hardly any connection with the radius of the yarns"),
            Statement("paper 2: a slight decline with thinner yarns"),
        ),
        base=QUICK if quick else (),
        chosen=(
            "The paper does not state how rope and core go with the yarns. Chosen: the radius of the helices stays "
            "4 mm, and with it angle, pitch and length; the undulation is the yarn's radius r; the core fills what is "
            "left, 4 mm - 2 r; the rope's diameter is 2 (4 mm + 2 r); the yarns' moduli stay, so that their stiffness "
            "goes with r^2; the sheave stays 40 mm."
        ),
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
