"""Study C of paper 2: braids of 8, 12 and 16 yarns.

./braidx shell python3 tests/studies/yarn_count.py
"""

from study import QUICK, Case, Statement, Study, main, yarn_of

ELEMENTS = {8: 32, 12: 36, 16: 48}  # per pitch: three or more from crossing to crossing
QUICK_ELEMENTS = {4: 16, 8: 24}
YARNS = yarn_of(0.7, 30.8e3)  # 20 GPa, as in the demo


def study(quick: bool = False) -> Study:
    counts = QUICK_ELEMENTS if quick else ELEMENTS
    cases = [
        Case(
            f"{count}",
            float(count),
            (
                f"braid.strands_per_direction=[{count // 2}, {count // 2}]",
                f"yarn.elements_per_pitch={elements}",
            ),
        )
        for count, elements in counts.items()
    ]
    return Study(
        name="yarn_count",
        title="C: number of yarns",
        quantity="yarns (-)",
        cases=tuple(cases),
        statements=(Statement("paper 2: hardly any connection with the number of yarns"),),
        base=QUICK if quick else YARNS,
        chosen=(
            "The paper does not state how the rope goes with the number of its yarns. 16 yarns of radius 1 mm do not "
            "fit on the demo's helices of 4 mm: at 60 degrees yarns cross every 3.14 mm. Chosen for all numbers: "
            "yarns of radius 0.7 mm and of the demo's moduli on those helices, the core as it follows, 2.6 mm; angle, "
            "pitch and length stay."
        ),
    )


if __name__ == "__main__":
    raise SystemExit(main(study))
