"""Numbers of the results as a text wants them, by the options of a run."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from bench import Bench, Outcome, error, errors, key

MISSING = "(not computed)"


class Lookup:
    """Looks up runs of a scene; without options that is its default."""

    def __init__(self, bench: Bench, outcomes: Mapping[str, Outcome]) -> None:
        self.bench, self.outcomes = bench, outcomes

    def error(self, **options: Any) -> str:
        """The error that is judged, in per cent."""
        outcome = self.outcomes.get(key(options))
        if outcome is None or outcome.failure:
            return MISSING
        missed = error(self.bench, outcome, self.outcomes)
        return f"{100 * missed:.2g} %" if math.isfinite(missed) else MISSING

    def of(self, result: str, **options: Any) -> str:
        """The error of one result, in per cent."""
        outcome = self.outcomes.get(key(options))
        found = {} if outcome is None else errors(self.bench, outcome, self.outcomes)
        return f"{100 * found[result]:.2g} %" if result in found else MISSING

    def value(self, result: str, **options: Any) -> str:
        """A result itself, three digits."""
        outcome = self.outcomes.get(key(options))
        known = outcome is not None and result in outcome.values
        return f"{outcome.values[result]:.3g}" if outcome and known else MISSING

    def unknowns(self, **options: Any) -> str:
        """Of the largest system."""
        return self._cost("unknowns", options)

    def iterations(self, **options: Any) -> str:
        """Of Newton's method."""
        return self._cost("iterations", options)

    def seconds(self, **options: Any) -> str:
        """CPU time."""
        return self._cost("seconds", options) + " s"

    def _cost(self, name: str, options: dict[str, Any]) -> str:
        outcome = self.outcomes.get(key(options))
        if outcome is None:
            return MISSING
        cost = getattr(outcome, name)
        return f"{cost:.3g}" if isinstance(cost, float) else str(cost)
