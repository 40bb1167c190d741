"""The states in which the ends of a bent rope turn back or come to rest, and the last whole cycle among them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...output import history
from .bend import NEAR, WAY


@dataclass(frozen=True)
class TurningPoint:
    """A state that a snapshot was kept of.

    Attributes:
        path: The snapshot.
        travel: Of the ends towards the sheave, mm.
        friction_work: Dissipated so far by all contacts, mJ.
    """

    path: Path
    travel: float
    friction_work: float


def turning_points(snapshots: Sequence[Path], rows: Path) -> list[TurningPoint]:
    """Turning points in the order of the run; none of a rope that was not bent.

    Args:
        snapshots: Files named after increment and state, in the order of the run.
        rows: history.csv.
    """
    columns = history.read(rows)
    increments = columns["increment"].astype(int)
    found = []
    for path in snapshots:
        number, name = path.stem.split("_", 1)
        row = np.flatnonzero(increments == int(number))
        if not len(row) or name.startswith(f"{WAY}_"):
            continue
        travel = float(columns["travel (mm)"][row[0]])
        if np.isfinite(travel):
            work = float(columns["friction work (mJ)"][row[0]])
            found.append(TurningPoint(path, travel, work))
    return found


def last_bent(points: Sequence[TurningPoint]) -> TurningPoint | None:
    """The last state in which the rope is bent as far as it has been, if it was bent."""
    furthest = max((point.travel for point in points), default=0.0)
    bent = [point for point in points if point.travel > furthest - NEAR > 0.0]
    return bent[-1] if bent else None


def last_cycle(points: Sequence[TurningPoint]) -> tuple[TurningPoint, TurningPoint] | None:
    """Begin and end of the last whole cycle: one travel, reached again after another one, if there is such."""
    for end in range(len(points) - 1, 1, -1):
        for begin in range(end - 2, -1, -1):
            if abs(points[begin].travel - points[end].travel) > NEAR:
                continue
            between = points[begin + 1 : end]
            if any(abs(point.travel - points[end].travel) > NEAR for point in between):
                return points[begin], points[end]
    return None
