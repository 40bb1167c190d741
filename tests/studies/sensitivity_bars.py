"""By how much results change when one choice is changed at a time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from study_runs import Outcome

BASE = "as in the demo"


@dataclass(frozen=True)
class Bar:
    """One choice and what its other values make of a result.

    Attributes:
        parameter: What is chosen.
        changes: Change of the result by the other value of the choice, %.
    """

    parameter: str
    changes: dict[str, float]

    @property
    def span(self) -> float:
        """Between the least and the largest change, no change being one of them, %."""
        values = [0.0, *self.changes.values()]
        return max(values) - min(values)


def bars(outcomes: Sequence[Outcome], column: str) -> list[Bar]:
    """One bar per parameter in the order of the cases, labelled "PARAMETER: VALUE"; the base is left out.

    Raises:
        StopIteration: If no outcome is that of the base.
    """
    base = next(o.values[column] for o in outcomes if o.case.label == BASE)
    changes: dict[str, dict[str, float]] = {}
    for outcome in outcomes:
        if outcome.case.label != BASE:
            parameter, value = outcome.case.label.split(": ")
            relative = 100.0 * (outcome.values[column] / base - 1.0)
            changes.setdefault(parameter, {})[value] = relative
    return [Bar(parameter, values) for parameter, values in changes.items()]


def widest_first(found: Sequence[Bar]) -> list[Bar]:
    """By span."""
    return sorted(found, key=lambda bar: -bar.span)
