"""history.csv: rows, resuming after a kill."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np

from braidx.output.history import COLUMNS, History, HistoryRow, read


def row(increment: int, strain: float | None = None, step: str = "pull") -> HistoryRow:
    force = None if strain is None else 9000.0 * strain
    return HistoryRow(increment, strain, force, 4, 1200, 0.01, 0.5, 1.25, step, 0.012, 1e-3)


def test_one_column_per_field_starting_with_the_contract() -> None:
    assert len(COLUMNS) == len(fields(HistoryRow))
    names = " ".join(COLUMNS[:8])
    for word in ("increment", "rope strain", "force (kN)", "Newton iterations", "contact elements"):
        assert word in names
    for word in ("max penetration", "friction work", "seconds"):
        assert word in names


def test_rows_are_on_disk_at_once_with_full_precision(tmp_path: Path) -> None:
    path = tmp_path / "history.csv"
    history = History(path)
    history.append(row(1, None, "form"))
    history.append(row(2, 0.1 + 0.2))
    columns = read(path)
    assert np.isnan(columns["rope strain (-)"][0])
    assert columns["rope strain (-)"][1] == 0.1 + 0.2
    assert list(columns["step"]) == ["form", "pull"]
    history.close()


def test_numpy_scalars_are_written_as_numbers(tmp_path: Path) -> None:
    with History(tmp_path / "h.csv") as history:
        history.append(row(np.int64(3), np.float64(0.25)))  # type: ignore[arg-type]
    assert "np." not in (tmp_path / "h.csv").read_text()
    assert read(tmp_path / "h.csv")["rope strain (-)"][0] == 0.25


def test_resume_drops_rows_after_the_checkpoint_and_a_torn_line(tmp_path: Path) -> None:
    path = tmp_path / "history.csv"
    with History(path) as history:
        for increment in range(1, 6):
            history.append(row(increment, 0.001 * increment))
    with path.open("a") as stream:
        stream.write("6,0.006,5")
    with History(path, after=3) as history:
        history.append(row(4, 0.04))
    columns = read(path)
    assert list(columns["increment"]) == [1, 2, 3, 4]
    assert columns["rope strain (-)"][-1] == 0.04


def test_a_new_run_starts_a_new_file(tmp_path: Path) -> None:
    path = tmp_path / "history.csv"
    with History(path) as history:
        history.append(row(1, 0.0))
    History(path).close()
    assert len(read(path)["increment"]) == 0
    path.unlink()
    History(path, after=7).close()
    assert path.read_text().startswith("increment,")
