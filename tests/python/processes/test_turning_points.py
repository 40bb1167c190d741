"""Which states of a bent rope bound a whole cycle."""

from __future__ import annotations

from pathlib import Path

import pytest

from braidx.output.history import History, HistoryRow
from braidx.processes.bending.turning_points import (
    TurningPoint,
    last_bent,
    last_cycle,
    turning_points,
)


def points(*travels: float) -> list[TurningPoint]:
    return [TurningPoint(Path(str(i)), travel, float(i)) for i, travel in enumerate(travels)]


@pytest.mark.parametrize(
    ("travels", "cycle"),
    [
        ((), None),
        ((0.0,), None),
        ((0.0, 60.0), None),
        ((0.0, 60.0, 0.0), (0, 2)),
        ((0.0, 60.0, 0.0, 60.0), (1, 3)),
        ((0.0, 60.0, 0.0, 60.0, 0.0), (2, 4)),
        ((0.0, 30.0, 60.0, 0.0), (0, 3)),
        ((0.0, 30.0, 30.0), None),  # the ends have not moved in between
        ((0.0, 30.0, 0.0, 60.0), (0, 2)),  # bent farther than before: not closed
    ],
)
def test_the_last_whole_cycle(travels, cycle):
    found = last_cycle(points(*travels))
    assert (found and tuple(int(point.path.name) for point in found)) == cycle


def test_the_last_state_bent_as_far_as_ever():
    assert last_bent(points(0.0, 60.0, 0.0, 60.0, 0.0)).friction_work == 3.0
    assert last_bent(points(0.0, 60.0, 0.0, 30.0)).friction_work == 1.0
    assert last_bent(points(0.0)) is None and last_bent([]) is None


def test_states_on_the_way_and_of_a_straight_rope_are_none(tmp_path):
    with History(tmp_path / "history.csv") as rows:
        for number, travel in enumerate([None, 0.0, 1.0, 2.0]):
            row = HistoryRow(
                number, None, None, 1, 0, 0.0, 10.0 * number, 0.1, "s", 0.0, 0.0, travel=travel
            )
            rows.append(row)
    names = ["00000_formed", "00001_clamped", "00002_travel_1.0_mm", "00003_bent", "00004_bent"]
    files = [tmp_path / f"{name}.npz" for name in names]  # the last one is not in the history
    found = turning_points(files, tmp_path / "history.csv")
    assert [(point.travel, point.friction_work) for point in found] == [(0.0, 10.0), (2.0, 30.0)]
    assert [point.path for point in found] == [files[1], files[3]]
