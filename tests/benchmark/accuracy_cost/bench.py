"""What is measured: scenes, the options that are varied in each, and what came of them."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).with_name("results")
Options = Mapping[str, Any]
Values = dict[str, float]


@dataclass(frozen=True)
class Sweep:
    """Runs that differ in one thing.

    Attributes:
        title: What differs.
        options: Of each run, what departs from the defaults of the scene; without any it is the default itself.
        labels: How each run is called in the chart.
        joined: Whether the runs are one series, as those of ever shorter elements are.
    """

    title: str
    options: tuple[Options, ...]
    labels: tuple[str, ...]
    joined: bool = True

    @property
    def is_mesh(self) -> bool:
        """Whether models and meshes differ, not how they are solved for."""
        return "degree" in self.title or self.title.startswith(("mixed", "cable", "beam", "solid"))


@dataclass(frozen=True)
class Bench:
    """A scene and its sweeps.

    Attributes:
        name: Of its files.
        title: Heading.
        says: What the scene is, and what its error is an error of.
        run: Computes the scene with options; gives results by name.
        judged: Results whose largest relative error is the error of a run.
        sweeps: All of them.
        exact: Exact results, or None; they may depend on options.
        reference: Options of the run that stands for exact results where there are none, by options of a run.
    """

    name: str
    title: str
    says: str
    run: Callable[..., Values]
    judged: tuple[str, ...]
    sweeps: tuple[Sweep, ...]
    exact: Callable[..., Values] | None = None
    reference: Callable[..., Options] | None = None

    def runs(self) -> Iterator[Options]:
        """Options of all runs, each once; references first, which errors are counted from."""
        seen = set()
        wanted = [options for sweep in self.sweeps for options in sweep.options]
        if self.reference is not None:
            wanted = [*(self.reference(**options) for options in wanted), *wanted]
        for options in wanted:
            if key(options) not in seen:
                seen.add(key(options))
                yield options


@dataclass(frozen=True)
class Outcome:
    """What came of a run.

    Attributes:
        options: Of the run.
        values: Its results; empty if it failed.
        seconds: CPU time of the process, which has one thread.
        unknowns: Of the largest system solved.
        iterations: Of Newton's method, failed attempts and forming included; 0 where they are not counted.
        failure: Why it failed; empty otherwise.
    """

    options: dict[str, Any]
    values: Values = field(default_factory=dict)
    seconds: float = math.nan
    unknowns: int = 0
    iterations: int = 0
    failure: str = ""


def key(options: Options) -> str:
    """Tells runs apart."""
    return json.dumps(dict(options), sort_keys=True)


def load(name: str, folder: Path = RESULTS) -> dict[str, Outcome]:
    """Stored outcomes of a scene by key of their options; none where nothing is stored."""
    path = folder / f"{name}.json"
    if not path.exists():
        return {}
    outcomes = (Outcome(**entry) for entry in json.loads(path.read_text("utf-8")))
    return {key(outcome.options): outcome for outcome in outcomes}


def store(name: str, outcomes: Mapping[str, Outcome], folder: Path = RESULTS) -> None:
    """Writes the outcomes of a scene, a line each."""
    lines = ",\n".join(json.dumps(asdict(outcome)) for outcome in outcomes.values())
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.json").write_text(f"[\n{lines}\n]\n", "utf-8")


def errors(bench: Bench, outcome: Outcome, outcomes: Mapping[str, Outcome]) -> Values:
    """Relative errors by result; none of a run that failed, or without its reference."""
    if bench.exact is not None:
        expected = bench.exact(**outcome.options)
    else:
        assert bench.reference is not None
        reference = outcomes.get(key(bench.reference(**outcome.options)))
        expected = {} if reference is None else reference.values
    return {
        name: abs(value / expected[name] - 1.0)
        for name, value in outcome.values.items()
        if expected.get(name)
    }


def error(bench: Bench, outcome: Outcome, outcomes: Mapping[str, Outcome]) -> float:
    """Largest error of the results that are judged; NaN where one is missing."""
    found = errors(bench, outcome, outcomes)
    return max((found.get(name, math.nan) for name in bench.judged), default=math.nan)


def front(points: list[tuple[float, float]]) -> list[int]:
    """Numbers of the points (cost, error) that none is both cheaper and more exact than, by cost."""
    best, found = math.inf, []
    for i in sorted(range(len(points)), key=lambda i: points[i]):
        if points[i][1] < best:
            best = points[i][1]
            found.append(i)
    return found
