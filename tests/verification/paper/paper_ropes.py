"""Ropes of the papers' studies (tests/studies), formed and pulled or bent side by side, each on one thread.

The rope of least friction comes to rest at the demo's 7 kN, not at the study's 2, which takes it a fifth longer: its
toe is behind it then, and strain counts from the formed rope all the same.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import islice
from pathlib import Path

import braiding_angle
import diameter_ratio
import friction_coefficient
import pitch_length
from study import Case, Study
from study_runs import Outcome, run_case

MOST = 4  # ropes at a time: each takes up to 2 GB
ANGLES, RATIOS, LEAST = ("30", "60"), ("3.33", "10.00"), "0.003"


def paper_ropes() -> dict[str, Study]:
    """What tests need of the studies. What takes longest comes first, so that no core is left waiting for it."""
    least = cases_of(friction_coefficient.study(), LEAST)
    return {
        "angle": cases_of(braiding_angle.study(), *ANGLES),
        "friction": replace(least, base=()),
        "pitch": pitch_length.study(),
        "ratio": cases_of(diameter_ratio.study(), *RATIOS),
    }


def cases_of(study: Study, *labels: str) -> Study:
    """A study of some of its cases."""
    kept = tuple(case for case in study.cases if case.label in labels)
    assert len(kept) == len(labels), labels
    return replace(study, cases=kept)


def compute(runs: Path, studies: dict[str, Study]) -> dict[str, list[Outcome]]:
    """All cases of some studies, as many at a time as there are cores; what `runs` has of them is taken as it is.

    No two of the cases may be of the same rope.
    """

    def run(study_and_case: tuple[Study, Case]) -> Outcome:
        return run_case(*study_and_case, runs)

    pairs = [(study, case) for study in studies.values() for case in study.cases]
    with ThreadPoolExecutor(min(len(os.sched_getaffinity(0)), MOST)) as pool:
        outcomes: Iterator[Outcome] = iter(list(pool.map(run, pairs)))
    return {name: list(islice(outcomes, len(study.cases))) for name, study in studies.items()}


def converged(outcomes: list[Outcome]) -> list[Outcome]:
    """The outcomes, every one of which has to be that of a run that converged."""
    failures = {o.case.label: o.failure for o in outcomes if o.failure}
    assert failures == {}
    return outcomes
