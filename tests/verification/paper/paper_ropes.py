"""Ropes of the papers' studies (tests/studies), formed and pulled or bent side by side, each on one thread."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import islice
from pathlib import Path

from study import Case, Study
from study_runs import Outcome, run_case

MOST = 4  # ropes at a time: each takes up to 2 GB


def cases_of(study: Study, *labels: str) -> Study:
    """A study of some of its cases."""
    kept = tuple(case for case in study.cases if case.label in labels)
    assert len(kept) == len(labels), labels
    return replace(study, cases=kept)


def compute(runs: Path, *studies: Study) -> list[list[Outcome]]:
    """All cases of some studies, as many at a time as there are cores; what `runs` has of them is taken as it is.

    No two of the cases may be of the same rope.
    """

    def run(study_and_case: tuple[Study, Case]) -> Outcome:
        return run_case(*study_and_case, runs)

    pairs = [(study, case) for study in studies for case in study.cases]
    with ThreadPoolExecutor(min(len(os.sched_getaffinity(0)), MOST)) as pool:
        outcomes: Iterator[Outcome] = iter(list(pool.map(run, pairs)))
    return [list(islice(outcomes, len(study.cases))) for study in studies]
