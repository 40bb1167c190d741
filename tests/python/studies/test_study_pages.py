"""What tests of the studies expect, against the results that their pages in docs/ hold.

The criteria are evaluated again from the tables of the pages, apart from the code that wrote them.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "tests" / "studies"))

from missed import MISSED  # noqa: E402
from study_page import DOES_NOT, HOLDS  # noqa: E402


def tables_of(page):
    """Cells of the tables of a page, without their headers."""
    tables, rows = [], []
    for line in [*(ROOT / "docs" / f"study_{page}.md").read_text("utf-8").splitlines(), ""]:
        if line.startswith("|"):
            rows.append([cell.strip() for cell in line.strip("|").split(" | ")])
        elif rows:
            tables.append(rows[2:])
            rows = []
    return tables


def column(page, number):
    return np.array([float(row[number]) for row in tables_of(page)[0]])


def verdict(page, beginning):
    """Whether the statement that begins so holds, as the page has it."""
    (row,) = (row for row in tables_of(page)[1] if row[0].startswith(beginning))
    return row[-1].strip("| ") == HOLDS


@pytest.mark.parametrize("page", MISSED)
def test_statements_that_do_not_hold_are_those_that_tests_expect(page):
    verdicts = {row[0]: row[-1].strip("| ") for row in tables_of(page)[1]}
    assert set(verdicts.values()) <= {HOLDS, DOES_NOT}
    missed = [said for said, found in verdicts.items() if found == DOES_NOT]
    assert len(missed) == len(MISSED[page])
    for beginning in MISSED[page].values():
        assert [said.startswith(beginning) for said in missed].count(True) == 1


def test_pitch():
    square, stiffness = column("pitch", 3), column("pitch", 5)
    assert verdict("pitch", "it evolves linearly") == (
        np.corrcoef(square, stiffness)[0, 1] ** 2 >= 0.95
    )
    exponent = np.polyfit(np.log(square), np.log(stiffness), 1)[0]
    assert verdict("pitch", "because strain and force") == (0.8 <= exponent <= 1.2)
    rises = stiffness[-1] > stiffness[0] and (stiffness[1:] >= 0.99 * stiffness[:-1]).all()
    assert verdict("pitch", "the axial stiffness rises") == rises
    at_132 = float(stiffness[column("pitch", 0) == 132.0][0])
    assert verdict("pitch", "at 132 mm 9512 kN") == (abs(at_132 / 9512.0 - 1.0) <= 0.1)


def test_friction():
    stiffness, toe = column("friction", 3), column("friction", 2)
    mean, deviation, along = column("friction", 7), column("friction", 8), column("friction", 10)
    same = np.ptp(stiffness) <= 0.05 * stiffness.mean()
    assert verdict("friction", "the rope's stiffness no longer") == same
    assert verdict("friction", "friction influences the beginning") == (np.diff(toe) < 0).all()
    assert verdict("friction", "a much larger variability") == (np.diff(deviation / mean) > 0).all()
    assert verdict("friction", "explained by non-uniform") == (np.diff(along / mean) > 0).all()


def test_bedding_in():
    lost, residual, linear = (column("bedding_in", number) for number in (1, 4, 6))
    fewer = lost[-1] < lost[0] and (lost[1:] <= 1.05 * lost[:-1]).all()
    assert verdict("bedding_in", "hysteresis tends to decrease") == fewer
    assert verdict("bedding_in", "most of the residual strain") == (
        residual[0] > 0.5 * residual[-1]
    )
    assert verdict("bedding_in", "the form of the curve") == (linear[-1] > linear[0])


def test_sensitivity():
    stiffness, efficiency, diameter = (column("sensitivity", number) for number in (1, 2, 4))
    assert verdict("sensitivity", "efficiency") == (efficiency.min() <= 0.699 <= efficiency.max())
    assert verdict("sensitivity", "diameter") == (diameter.min() <= 19.0 <= diameter.max())
    labels = [row[0] for row in tables_of("sensitivity")[0]]
    (bundle,) = (k for k, label in enumerate(labels) if label.startswith("bundle factor"))
    little = abs(stiffness[bundle] / stiffness[0] - 1.0) < 0.05
    assert verdict("sensitivity", "bending and torsion") == little
