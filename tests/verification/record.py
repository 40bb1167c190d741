"""What the cases state: expected and computed values, which the page of the documentation is made of."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

FAMILIES = {  # by folder
    "yarn": "yarn",
    "contact": "contact",
    "rope": "strands",
    "solid": "solids",
    "paper": "papers",
}


@dataclass(frozen=True)
class Row:
    """One statement of a case.

    Attributes:
        case: "V1" and the like.
        what: What is compared.
        expected, computed: Of the worst entry where an array is compared.
        error, tolerance: Over the size that errors are judged by, -.
        count: Number of values compared.
        seconds: That the test took until this statement.
        unknowns: Of the finest model.
        order: Least of the orders of convergence from mesh to mesh, where there are some.
        meshes: Numbers of elements, or of steps, and the error on each.
        missed: Why the tolerance is not met, where that is so.
    """

    case: str
    what: str
    expected: float
    computed: float
    error: float
    tolerance: float
    count: int = 1
    seconds: float = 0.0
    unknowns: int = 0
    order: float | None = None
    meshes: tuple[tuple[int, float], ...] = ()
    missed: str = ""


@dataclass(frozen=True)
class Verdict:
    """What a paper says in words, and what became of it.

    Attributes:
        case: "R6" and the like.
        said: What the paper says.
        criterion: When that is taken to hold.
        found: What was computed.
        missed: Why it does not hold, where that is so.
    """

    case: str
    said: str
    criterion: str
    found: str
    missed: str = ""


@dataclass
class Records:
    """All statements of a session, by family."""

    rows: dict[str, list[Row]] = field(default_factory=dict)
    verdicts: dict[str, list[Verdict]] = field(default_factory=dict)

    def add(self, family: str, row: Row) -> None:
        """Statements that read the same count as one, whose worst value is shown."""
        rows = self.rows.setdefault(family, [])
        for i, other in enumerate(rows):
            if (other.case, other.what, other.tolerance) == (row.case, row.what, row.tolerance):
                worst = max(row, other, key=lambda r: r.error)
                both = {
                    "count": row.count + other.count,
                    "seconds": row.seconds + other.seconds,
                    "unknowns": max(row.unknowns, other.unknowns),
                }
                rows[i] = Row(**(vars(worst) | both))
                return
        rows.append(row)


class Recorder:
    """Takes down the statements of one test, and has them hold."""

    def __init__(self, records: Records, family: str) -> None:
        self._records, self._family = records, family
        self._since = time.perf_counter()

    def check(
        self,
        case: str,
        what: str,
        computed: npt.ArrayLike,
        expected: npt.ArrayLike,
        tolerance: float,
        *,
        scale: float | None = None,
        unknowns: int = 0,
        missed: str = "",
        measured: float = 0.0,
        seconds: float | None = None,
    ) -> None:
        """States that values are as expected.

        Args:
            computed, expected: Numbers, or arrays of any shapes that fit each other.
            tolerance: Of the error over `scale`, which is the expected value of each entry by default.
            missed: Why the tolerance is known to be missed; `measured` is then what the error must not exceed.
            seconds: That the values took; those since the last statement by default.
        """
        got, wanted = np.broadcast_arrays(np.asarray(computed, float), np.asarray(expected, float))
        errors = np.abs(got - wanted) / (np.abs(wanted) if scale is None else scale)
        worst = int(np.argmax(errors))
        values = (float(a.ravel()[worst]) for a in (wanted, got, errors))
        seconds = self._seconds() if seconds is None else seconds
        why = missed if errors.max() > tolerance else ""
        row = Row(case, what, *values, tolerance, got.size, seconds, unknowns, missed=why)
        self._records.add(self._family, row)
        assert row.error <= max(tolerance, measured), row

    def converges(
        self,
        case: str,
        what: str,
        meshes: Sequence[int],
        errors: Sequence[float],
        least_order: float,
        *,
        largest: float = np.inf,
        unknowns: int = 0,
    ) -> None:
        """States that errors fall with the number of elements or steps with an order at least.

        Args:
            largest: Bound on the error of the finest.
        """
        orders = np.diff(np.log(errors)) / -np.diff(np.log(meshes))
        pairs = tuple((int(n), float(e)) for n, e in zip(meshes, errors, strict=True))
        finest, seconds = pairs[-1][1], self._seconds()
        row = Row(case, what, 0.0, finest, finest, largest, 1, seconds, unknowns)
        row = Row(**(vars(row) | {"order": float(orders.min()), "meshes": pairs}))
        self._records.add(self._family, row)
        assert orders.min() >= least_order and finest <= largest, row

    def judge(
        self, case: str, said: str, criterion: str, found: str, holds: bool, *, missed: str = ""
    ) -> None:
        """States whether what a paper says in words holds.

        Args:
            said, criterion, found: What the paper says, when that is taken to hold, and what was computed.
            missed: Why it is known not to hold; should it hold nevertheless, this is to be taken away.
        """
        verdict = Verdict(case, said, criterion, found, missed)
        self._records.verdicts.setdefault(self._family, []).append(verdict)
        assert holds != bool(missed), verdict

    def _seconds(self) -> float:
        """Since the last statement."""
        before, self._since = self._since, time.perf_counter()
        return self._since - before
