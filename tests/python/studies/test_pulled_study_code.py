"""What studies of pulled ropes read off their runs: lines, spreads of stress, cycles, bars; how pages are made."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[2] / "studies"))

from friction_figure import histogram_edges  # noqa: E402
from load_cycles import load_cycles  # noqa: E402
from pulled_values import Curve, straight_line  # noqa: E402
from rope_shape import efficiency_of_directions, helix_angle, strand_radius  # noqa: E402
from sensitivity_bars import BASE, bars, widest_first  # noqa: E402
from stress_spread import spread  # noqa: E402
from study import Case, Study  # noqa: E402
from study_page import DOES_NOT, HOLDS, Claim, Page, verdicts, write  # noqa: E402
from study_runs import Outcome  # noqa: E402

from braidx.output import Snapshot  # noqa: E402


def test_straight_line():
    x = np.array([0.0, 1.0, 2.0, 3.0])
    line = straight_line(x, 2.0 * x - 1.0)
    assert (line.slope, line.constant, line.r_squared) == pytest.approx((2.0, -1.0, 1.0))
    assert line(np.array([5.0])) == pytest.approx([9.0])
    # By hand: slope 8 / 5 of (0, 0), (1, 1), (2, 4), (3, 4), constant -0.15; residuals squared 1.35 of 12.75.
    bent = straight_line(x, np.array([0.0, 1.0, 4.0, 4.0]))
    assert (bent.slope, bent.constant) == pytest.approx((1.5, 0.0))
    assert bent.r_squared == pytest.approx(1.0 - 1.5 / 12.75)
    assert straight_line(x, np.ones(4)).r_squared == 1.0
    with pytest.raises(ValueError, match="2 point"):
        straight_line(np.ones(2), np.ones(2))


def helix_rope(radius=3.0, pitch=40.0, offset=0.5):
    """Two strands of two yarns each that lie beside the strand's helix, on either side."""
    z = np.linspace(0.0, pitch, 401)
    lines = []
    for sense in (1.0, -1.0):
        turn = sense * 2.0 * np.pi * z / pitch
        for side in (-offset, offset):
            lines.append(np.stack([radius * np.cos(turn) + side, radius * np.sin(turn), z], axis=1))
    segments = [len(line) - 1 for line in lines]
    stress = [np.full(n, 100.0 + 10.0 * i) for i, n in enumerate(segments)]
    for values in stress:
        values[::2] += 3.0
        values[1::2] -= 3.0
    return Snapshot(
        "70 kN", tuple(lines), np.full(4, 0.5), np.array([0, 0, 1, 1]), axial_stress=tuple(stress)
    )


def test_shape_of_strands():
    rope = helix_rope()
    assert strand_radius(rope) == pytest.approx(3.0, rel=1e-4)
    angle = helix_angle(3.0, 40.0)
    assert efficiency_of_directions(rope) == pytest.approx(math.cos(angle) ** 3, rel=1e-4)


def test_spread_of_stress_is_that_among_yarns_and_along_them():
    found = spread(helix_rope())
    assert found.mean == pytest.approx(115.0)
    assert found.yarn_means == pytest.approx([100.0, 110.0, 120.0, 130.0])
    assert found.among == pytest.approx(math.sqrt(125.0))
    assert found.along == pytest.approx(3.0)
    assert found.deviation == pytest.approx(math.hypot(found.among, found.along))
    assert found.highest == pytest.approx(133.0 / 115.0)


def test_edges_hold_all_values():
    values = np.array([3.0, 7.0, 11.0])
    edges = histogram_edges(values, 9)
    assert len(edges) == 9 and edges[0] < 3.0 and edges[-1] > 11.0
    assert np.histogram(values, edges)[0].sum() == 3


def test_cycles_of_a_curve():
    """A parallelogram, entered along its own first line: rigid sliding at +-1 kN about F = 100 kN strain."""
    strain = np.concatenate([[0.0, 0.1, 0.2], [0.1, 0.05], [0.1, 0.2], [0.12, 0.07], [0.3]])
    force = np.concatenate([[1.0, 11.0, 21.0], [9.0, 1.0], [9.0, 21.0], [11.0, 1.0], [31.0]])
    work = np.concatenate([[0.0, 1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 7.5], [9.0]])
    first, second = load_cycles(Curve(strain, force, work, 0.0 * work, 0.0 * work))
    pulled = 0.1 * (6.0 + 16.0)
    released = 0.1 * 15.0 + 0.05 * 5.0
    assert first.pulled == pytest.approx(1e3 * pulled)
    assert first.hysteresis == pytest.approx(1e3 * (pulled - released))
    assert (first.friction_work, second.friction_work) == pytest.approx((4.0, 3.5))
    assert (first.residual_strain, second.residual_strain) == pytest.approx((0.05, 0.07))
    assert first.linearity == pytest.approx(1.0) and second.linearity < 1.0
    with pytest.raises(ValueError, match="never released"):
        load_cycles(Curve(*[values[:3] for values in (strain, force, work, work, work)]))


def outcomes_of(values):
    return [Outcome(Case(label, 0.0), {"EA": value}) for label, value in values.items()]


def test_bars_are_changes_from_the_base_the_widest_first():
    cases = {BASE: 200.0, "a (1): 2": 202.0, "b (1): 0": 190.0, "b (1): 3": 206.0}
    found = widest_first(bars(outcomes_of(cases), "EA"))
    assert [bar.parameter for bar in found] == ["b (1)", "a (1)"]
    assert found[0].changes == pytest.approx({"0": -5.0, "3": 3.0})
    assert [bar.span for bar in found] == pytest.approx([8.0, 1.0])


def test_verdicts():
    rows = verdicts(
        [Claim("one", "s", "c", "f", True), Claim("two", "s", "c", "f", False)]
    ).splitlines()
    assert rows[2].endswith(f"| {HOLDS} |") and rows[3].endswith(f"| {DOES_NOT} |")


def test_a_page_is_of_all_cases_or_says_what_became_of_each(tmp_path, monkeypatch):
    (tmp_path / "p.md").write_text("# {title}\n\n{verdicts}\nIt is {number:.1f}.\n", "utf-8")
    monkeypatch.setattr("study_page.PAGES", tmp_path)
    drawn = []
    page = Page(
        "p",
        lambda outcomes: [Claim("one", "said", "if", "found", True)],
        lambda outcomes: {"number": 1.25},
        lambda outcomes, folder: drawn.append(folder),
    )
    done = outcomes_of({"one": 1.0, "two": 2.0})
    study = Study("p", "Title", "case", tuple(outcome.case for outcome in done))
    text = write(page, study, done, tmp_path / "out")
    assert (tmp_path / "out" / "study_p.md").read_text("utf-8") == text
    assert text.startswith("# Title") and "| said | if | found | holds |" in text
    assert "It is 1.2." in text and drawn == [tmp_path / "out" / "images"]
    lost = [done[0], Outcome(done[1].case, failure="not converged: increment 3")]
    for some, last in ((done[:1], "converged | 1"), (lost, "not converged: increment 3 | ")):
        text = write(page, study, some, tmp_path / "out")
        assert text.startswith("# Title") and last in text and "It is" not in text
    assert len(drawn) == 1
