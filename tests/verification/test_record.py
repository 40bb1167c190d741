"""What cases state is taken down as it is, and has to hold."""

import pytest
from record import Recorder, Records
from record_page import line, verdict_line


@pytest.fixture
def records():
    return Records()


@pytest.fixture
def recorder(records):
    return Recorder(records, "yarn")


def test_worst_entry_is_shown(records, recorder):
    recorder.check("V1", "lengths", [1.0, 2.2, 3.0], [1.0, 2.0, 3.0], 0.11, unknowns=9)
    (row,) = records.rows["yarn"]
    assert (row.expected, row.computed, row.count, row.unknowns) == (2.0, 2.2, 3, 9)
    assert row.error == pytest.approx(0.1)
    assert line(row).startswith("| V1 | lengths (worst of 3) | 2 | 2.2 | 0.1 | 0.11 |  | 9 | ")


def test_errors_over_a_scale(records, recorder):
    recorder.check("V1", "forces", [0.2, 0.0], 0.0, 0.05, scale=10.0)
    assert records.rows["yarn"][0].error == pytest.approx(0.02)


def test_what_does_not_hold_fails_and_is_taken_down(records, recorder):
    with pytest.raises(AssertionError):
        recorder.check("V1", "force", 1.1, 1.0, 0.05)
    with pytest.raises(AssertionError):
        recorder.check("V1", "no number", float("nan"), 1.0, 0.05)
    assert len(records.rows["yarn"]) == 2


def test_what_is_known_to_be_missed_must_not_get_worse(records, recorder):
    recorder.check("V1", "force", 1.1, 1.0, 0.05, missed="too coarse", measured=0.12)
    assert "**missed**" in line(records.rows["yarn"][0])
    with pytest.raises(AssertionError):
        recorder.check("V1", "force", 1.2, 1.0, 0.05, missed="too coarse", measured=0.12)
    recorder.check("V1", "moment", 1.01, 1.0, 0.05, missed="too coarse", measured=0.12)
    assert "missed" not in line(records.rows["yarn"][1])


def test_statements_that_read_the_same_are_one(records, recorder):
    for value in (1.01, 1.03, 1.02):
        recorder.check("V1", "force", value, 1.0, 0.05)
    (row,) = records.rows["yarn"]
    assert (row.computed, row.count) == (1.03, 3)


def test_statements_in_words_have_to_hold(records, recorder):
    recorder.judge("R6", "it rises", "it does", "1, 2", True)
    with pytest.raises(AssertionError):
        recorder.judge("R6", "it rises", "it does", "2, 1", False)
    lines = [verdict_line(verdict) for verdict in records.verdicts["yarn"]]
    assert lines == ["| R6 | it rises | it does | 1, 2 | holds |"] + lines[1:]


def test_statements_in_words_that_are_missed_have_to_be_missed(records, recorder):
    recorder.judge("R6", "it rises", "it does", "2, 1", False, missed="too coarse")
    assert verdict_line(records.verdicts["yarn"][0]).endswith("| **missed** |")
    with pytest.raises(AssertionError):
        recorder.judge("R6", "it rises", "it does", "1, 2", True, missed="too coarse")


def test_convergence(records, recorder):
    recorder.converges("V1", "axis", (4, 8, 16), (0.16, 0.04, 0.011), 1.8)
    (row,) = records.rows["yarn"]
    assert row.order == pytest.approx(1.86, abs=0.01) and len(row.meshes) == 3
    with pytest.raises(AssertionError):
        recorder.converges("V1", "axis", (4, 8), (0.1, 0.05), 1.8)
