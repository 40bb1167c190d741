"""summary.json: the results of a run beside what was expected, and what they cost."""

from __future__ import annotations

import json
import math
import os
import resource
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Protocol


class Expected(Protocol):
    """An expected value, as a scene states it."""

    @property
    def reference(self) -> float: ...

    @property
    def source(self) -> str: ...

    @property
    def tolerance(self) -> float | None: ...


@dataclass(frozen=True)
class Reference:
    """An expected value, as summary.json states it."""

    reference: float
    source: str
    tolerance: float | None


@dataclass(frozen=True)
class Result:
    """One entry of `results`; `met` is None where nothing was expected. `state` says of which state it is."""

    value: float | int | None
    unit: str
    reference: float | None = None
    source: str | None = None
    tolerance: float | None = None
    met: bool | None = None
    state: str | None = None


@dataclass
class PhaseCost:
    """What one phase (form, settle, pull, ...) cost."""

    seconds: float = 0.0
    increments: int = 0
    newton_iterations: int = 0
    linear_solves: int = 0


@dataclass
class Cost:
    """What a run cost. `unknowns` and `contact_elements` are the largest numbers reached;
    `threads` are those of the contact engine, per process."""

    phases: dict[str, PhaseCost] = field(default_factory=dict)
    peak_memory_MB: float = 0.0
    unknowns: int = 0
    contact_elements: int = 0
    ranks: int = 1
    threads: int = 1


def is_met(value: float | None, reference: float, tolerance: float) -> bool:
    """Whether a value is as expected.

    The tolerance is a fraction of the reference; where the reference is zero it is the largest
    magnitude allowed, in the result's own unit. A value that is missing or not finite is not met.
    """
    if value is None or not math.isfinite(value):
        return False
    return abs(value - reference) <= tolerance * (abs(reference) or 1.0)


class Summary:
    """Collects the results of a run and writes summary.json.

    Args:
        scene: Name of the scene.
        expected: Expected value per result name. An expected result that the run never sets is
            written as a missing value that is not met.

    Attributes:
        accuracy: The accuracy that was asked for, and which options were chosen for it; None if none was.
    """

    def __init__(self, scene: str, expected: Mapping[str, Expected] | None = None) -> None:
        self.scene = scene
        self.converged = False
        self.cost = Cost()
        self.results: dict[str, Result] = {}
        self.accuracy: Mapping[str, Any] | None = None
        self._expected = dict(expected or {})
        for name in self._expected:
            self.set(name, None, "")

    def set(self, name: str, value: float | None, unit: str, state: str | None = None) -> Result:
        """Set a result in its unit ("-" for a ratio, "count" for a number of things), of a named state."""
        number: float | int | None = None
        if value is not None and math.isfinite(value):
            number = int(value) if unit == "count" else float(value)
        expected = self._expected.get(name)
        if expected is None:
            result = Result(number, unit, state=state)
        else:
            tolerance = expected.tolerance
            met = None if tolerance is None else is_met(number, expected.reference, tolerance)
            result = Result(
                number, unit, expected.reference, expected.source, tolerance, met, state
            )
        self.results[name] = result
        return result

    @property
    def all_met(self) -> bool:
        """Whether no expected result is missed."""
        return all(result.met is not False for result in self.results.values())

    def as_dict(self) -> dict[str, Any]:
        """The contents of summary.json; numbers that are not finite become null."""
        contents = {
            "scene": self.scene,
            "converged": self.converged,
            "results": {name: asdict(result) for name, result in self.results.items()},
            "cost": asdict(self.cost),
        }
        if self.accuracy is not None:
            contents["accuracy"] = dict(self.accuracy)
        finite: dict[str, Any] = _finite(contents)
        return finite

    def write(self, path: Path) -> None:
        """Write the file; it appears whole or not at all."""
        part = path.with_name(path.name + ".part")
        part.write_text(json.dumps(self.as_dict(), indent=2, allow_nan=False) + "\n", "utf-8")
        os.replace(part, path)


def read_references(path: Path) -> dict[str, Reference]:
    """The expected values in a summary.json, by name of the result."""
    results = json.loads(path.read_text("utf-8"))["results"]
    keys = ("reference", "source", "tolerance")
    return {
        name: Reference(**{key: entry[key] for key in keys})
        for name, entry in results.items()
        if entry["reference"] is not None
    }


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def peak_memory_MB() -> float:
    """Largest resident memory of this process so far, MB (1e6 bytes)."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6
