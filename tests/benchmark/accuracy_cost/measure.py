"""Accuracy against cost: computes what is not stored yet, and writes docs/accuracy.md and its charts.

    ./braidx shell python3 tests/benchmark/accuracy_cost/measure.py [SCENE ...] [--page] [--again]

Results are stored in tests/benchmark/accuracy_cost/results, one file per scene, after every run. An hour on one core if
nothing is; `--page` computes nothing.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

os.environ["BRAIDX_THREADS"] = "1"  # before the engine is asked how many there are

from bench import Bench, Options, Outcome, error, key, load, store  # noqa: E402
from scenes import BENCHES  # noqa: E402
from tally import tally  # noqa: E402

SHORT = 1.0  # CPU seconds below which a run is repeated, the quickest of
REPEATS = 2  # counting: the first compiles forms, and all are disturbed
LIMIT = 75.0  # CPU seconds after which a run is stopped
FORMS = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "fenics"


def measure(bench: Bench, options: Options) -> Outcome:
    """Runs a scene; again where it was quick, or where forms had to be compiled."""
    best: Outcome | None = None
    for _ in range(REPEATS):
        compiled = num_forms()
        outcome = attempt(bench, options)
        if best is None or outcome.seconds < best.seconds:
            best = outcome
        if outcome.failure or (outcome.seconds > SHORT and num_forms() == compiled):
            break
    assert best is not None
    return best


def attempt(bench: Bench, options: Options) -> Outcome:
    """Runs a scene once; a failure is an outcome, too."""
    values, failure = {}, ""
    with tally() as counted:
        try:
            with stopped_after(LIMIT):
                values = bench.run(**options)
        except OutOfTime:
            failure = f"no end after {LIMIT:g} s of CPU time"
        except Exception as error:
            failure = f"{type(error).__name__}: {error}".splitlines()[0][:200]
    # Of scenes that do not use braidx's own solver they tell the number themselves.
    unknowns = counted.unknowns or int(values.pop("unknowns", 0))
    seconds = round(counted.seconds, 3)
    return Outcome(dict(options), values, seconds, unknowns, counted.iterations, failure)


class OutOfTime(BaseException):
    """A run takes too long; nothing on the way may take it for an error of its own."""


@contextmanager
def stopped_after(seconds: float) -> Iterator[None]:
    """Raises OutOfTime once so much CPU time is spent, again and again until it gets through."""

    def stop(*words: Any) -> None:
        raise OutOfTime

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def num_forms() -> int:
    """Compiled forms in the cache of DOLFINx."""
    return len(list(FORMS.glob("*.so"))) if FORMS.is_dir() else 0


def compute(bench: Bench, again: bool) -> None:
    """All runs of a scene that are not stored, or all; a line is printed for each."""
    outcomes = load(bench.name)
    for options in bench.runs():
        known = outcomes.get(key(options))
        if known is not None and (known.failure or not again):
            continue
        outcome = measure(bench, options)
        if known is not None and known.iterations == outcome.iterations:
            outcome = min(known, outcome, key=lambda each: each.seconds)
        outcomes[key(options)] = outcome
        store(bench.name, outcomes)
        told = outcome.failure or f"error {error(bench, outcome, outcomes):.2e}"
        cost = (
            f"{outcome.seconds:.2f} s, {outcome.unknowns} unknowns, {outcome.iterations} iterations"
        )
        print(f"{bench.name} {dict(options)}: {told}; {cost}", flush=True)


def main() -> None:
    names = [bench.name for bench in BENCHES]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=", ".join(names))
    parser.add_argument("--page", action="store_true", help="write page and charts only")
    parser.add_argument(
        "--again",
        action="store_true",
        help="compute what is stored, too; of runs that are the same the quicker one counts",
    )
    words = parser.parse_args()
    for name in set(words.scenes) - set(names):
        parser.error(f"{name!r}: no such scene; choose from {', '.join(names)}")
    for bench in [] if words.page else BENCHES:
        if bench.name in (words.scenes or names):
            compute(bench, words.again)
    sys.stdout.flush()
    from page import write

    write()


if __name__ == "__main__":
    main()
