"""history.csv: one row per increment, written as the run goes, cut back on a resume."""

from __future__ import annotations

import csv
import os
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

COLUMNS = (
    "increment",
    "rope strain (-)",
    "force (kN)",
    "Newton iterations",
    "contact elements",
    "max penetration (mm)",
    "friction work (mJ)",
    "seconds",
    "step",
    "max penetration / radius (-)",
    "stabilisation residual share (-)",
    "linear solves",
    "contact updates",
    "cuts",
    "moment (N mm)",
    "travel (mm)",
    "stabilisation work share (-)",
    "run (mm)",
)


@dataclass(frozen=True)
class HistoryRow:
    """One increment. The order of the fields is that of `COLUMNS`.

    `increment` counts through all steps of a run. `rope_strain` is None while the rope is still
    being formed: it has no reference length yet. `moment` is given where groups of ends have conditions,
    `travel` where a rope is bent over a sheave.
    """

    increment: int
    rope_strain: float | None  # -
    force: float | None  # kN, tension positive
    newton_iterations: int
    contact_elements: int
    max_penetration: float  # mm, positive
    friction_work: float  # mJ, since the start of the run
    seconds: float
    step: str
    penetration_over_radius: float  # -
    stabilisation_residual_share: (
        float  # -, work of it still in accepted states, over the internal energy
    )
    linear_solves: int = 0
    contact_updates: int = 0
    cuts: int = 0
    moment: float | None = None  # N mm, about the axis, on the last section
    travel: float | None = None  # mm, of the ends of a bent rope towards the sheave
    stabilisation_work_share: float = (
        0.0  # -, all of its work since the rope was formed, over the internal energy
    )
    run: float | None = None  # mm, way of a bent rope over the sheave


class History:
    """The open history of a run.

    Args:
        path: The csv file.
        after: Keep the rows up to and including this increment and append behind them
            (a resume); None starts a new file.
    """

    def __init__(self, path: Path, after: int | None = None) -> None:
        if after is None or not path.exists():
            _rewrite(path, [])
        else:
            _rewrite(path, [row for row in _complete_rows(path) if int(row[0]) <= after])
        self._file: TextIO = path.open("a", newline="", encoding="utf-8")
        self._writer = csv.writer(self._file, lineterminator="\n")

    def append(self, row: HistoryRow) -> None:
        """Write one row and hand it to the operating system."""
        self._writer.writerow(["" if value is None else value for value in _plain(row)])
        self._file.flush()

    def close(self) -> None:
        self._file.close()

    def __enter__(self) -> History:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def read(path: Path) -> dict[str, NDArray[np.generic]]:
    """Columns by their header; empty cells are NaN, `step` is an array of strings."""
    rows = _complete_rows(path)
    columns: dict[str, NDArray[np.generic]] = {}
    for position, name in enumerate(COLUMNS):
        cells = [row[position] for row in rows]
        if name == "step":
            columns[name] = np.array(cells, dtype=str)
        else:
            columns[name] = np.array([float(c) if c else np.nan for c in cells], dtype=float)
    return columns


def _plain(row: HistoryRow) -> tuple[object, ...]:
    """Python scalars, whatever number types the row was filled with."""
    return tuple(v.item() if isinstance(v, np.generic) else v for v in astuple(row))


def _complete_rows(path: Path) -> list[list[str]]:
    """All rows below the header; a last line cut short by a killed run is dropped."""
    text = path.read_text("utf-8")
    whole = text[: text.rfind("\n") + 1]
    rows = list(csv.reader(whole.splitlines()))[1:]
    return [row for row in rows if len(row) == len(COLUMNS)]


def _rewrite(path: Path, rows: list[list[str]]) -> None:
    part = path.with_name(path.name + ".part")
    with part.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows)
    os.replace(part, path)
