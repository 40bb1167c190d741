"""What happens at each crossing of a bent rope, and the table of it, crossings.csv."""

from __future__ import annotations

import csv
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...output import snapshot
from ...output.figures.unrolled import from_sheave
from ...output.interlacing import per_crossing, relative_displacement, work_per_crossing
from ...output.interlacing_points import InterlacingPoints
from ...output.log import LOGGER
from ...system.constraints import Floats, Ints
from .turning_points import TurningPoint, last_bent, last_cycle

FILE = "crossings.csv"
COLUMNS = (
    "yarn a",
    "yarn b",
    "z (mm)",
    "angle (degrees)",
    "relative displacement (mm)",
    "normal force (N)",
    "friction work (mJ)",
    "friction work per cycle (mJ)",
)
LOST = 0.05  # of a cycle's work: contact elements that open take theirs with them


@dataclass(frozen=True)
class Crossings:
    """All crossings of a rope (k of them), in the order of the interlacing points.

    Attributes:
        points: Of the straight rope.
        displacement: Relative displacement of the two yarns when bent last, shape (k,), mm; NaN where lost.
        normal_force: Of the two yarns on each other when bent last, shape (k,), N.
        work: Of friction until then, shape (k,), mJ.
        cycle_work: Of friction in the last whole cycle, shape (k,), mJ; None if there was none.
    """

    points: InterlacingPoints
    displacement: Floats
    normal_force: Floats
    work: Floats
    cycle_work: Floats | None


def crossings_of(
    lines: Sequence[Floats], layer: Ints, points: Sequence[TurningPoint]
) -> Crossings | None:
    """Crossings of a rope that was bent, None of another one.

    Args:
        lines: Centre lines of the straight rope, shape (num_nodes, 3) each, mm.
        layer: Direction of each yarn, 0 or 1, shape (num_yarns,).
        points: Turning points of the run.
    """
    at, cycle = last_bent(points), last_cycle(points)
    if at is None:
        return None
    bent = snapshot.load(at.path)
    assert bent.contacts is not None
    slid = relative_displacement(lines, bent.centre_lines, bent.radius, layer)
    return Crossings(
        points=slid.reference,
        displacement=slid.magnitude,
        normal_force=per_crossing(slid, bent.contacts, bent.contacts.normal_force),
        work=work_per_crossing(slid, bent.contacts),
        cycle_work=_cycle_work(lines, layer, *cycle) if cycle else None,
    )


def _cycle_work(
    lines: Sequence[Floats], layer: Ints, begin: TurningPoint, end: TurningPoint
) -> Floats:
    """Difference of what contact elements have dissipated until the end of a cycle and until its begin."""
    work, total = [], []
    for point in (begin, end):
        state = snapshot.load(point.path)
        assert state.contacts is not None
        slid = relative_displacement(lines, state.centre_lines, state.radius, layer)
        work.append(work_per_crossing(slid, state.contacts))
        total.append(float(state.contacts.work.sum()))
    whole = end.friction_work - begin.friction_work
    lost = whole - (total[1] - total[0])
    if lost > LOST * whole:
        LOGGER.warning(
            "work per cycle: %.0f %% of it was done by contacts that are open again, and is missing at the crossings",
            100.0 * lost / whole,
        )
    # Where a contact has opened the difference would be negative; friction does not give work back.
    return np.maximum(work[1] - work[0], 0.0)


def write_crossings(crossings: Crossings, path: Path) -> None:
    """One row per crossing; z and angle (from the side of the sheave) are those of the straight rope.

    Cells of what is not known are empty. The file appears whole or not at all.
    """
    points = crossings.points
    x, y, z = points.position.T
    angle = from_sheave(np.arctan2(y, x))
    cycle = crossings.cycle_work
    if cycle is None:
        cycle = np.full(len(points), np.nan)
    numbers = np.stack(
        [z, angle, crossings.displacement, crossings.normal_force, crossings.work, cycle], axis=1
    )
    part = path.with_name(path.name + ".part")
    with part.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        for a, b, row in zip(points.yarn_a, points.yarn_b, numbers, strict=True):
            cells = [f"{value:.9g}" if np.isfinite(value) else "" for value in row]
            writer.writerow([int(a), int(b), *cells])
    os.replace(part, path)


def read_crossings(path: Path) -> dict[str, Floats]:
    """Columns of a table by their header; empty cells are NaN."""
    with path.open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    return {
        name: np.array([float(row[name] or "nan") for row in rows], dtype=float) for name in COLUMNS
    }
