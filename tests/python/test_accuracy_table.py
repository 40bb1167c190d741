"""Accuracy against cost: page and table are those of the stored results, and the results are still reproduced."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "tests" / "benchmark" / "accuracy_cost"))

import measure  # noqa: E402
import page  # noqa: E402
import rows  # noqa: E402
from bench import front, key, load  # noqa: E402
from scenes import BENCHES  # noqa: E402

from braidx.scene.accuracy import BENT, LEVELS, PULLED  # noqa: E402

BY_NAME = {bench.name: bench for bench in BENCHES}


@pytest.mark.parametrize("name", BY_NAME)
def test_all_runs_are_stored(name):
    missing = [options for options in BY_NAME[name].runs() if key(options) not in load(name)]
    assert missing == []


def test_the_page_is_that_of_the_results():
    assert page.page() == (ROOT / "docs" / "accuracy.md").read_text("utf-8")


@pytest.mark.parametrize(("name", "table"), [("pulled", PULLED), ("bent", BENT)])
def test_the_table_of_accuracies_is_that_of_the_results(name, table):
    found = rows.derived(name)
    for level in LEVELS:
        assert rows.agree(table[level], found[level]), (level, found[level])


def test_the_front_is_what_none_is_better_than():
    rng = np.random.default_rng(1)
    points = [tuple(point) for point in rng.integers(1, 9, (40, 2)).astype(float)]
    best = {
        point
        for point in points
        if not any(o != point and o[0] <= point[0] and o[1] <= point[1] for o in points)
    }
    chosen = [points[i] for i in front(points)]
    assert set(chosen) == best and len(chosen) == len(best)


@pytest.mark.parametrize(
    ("name", "options"), [("fibres", {"degree": 1, "spans": 20}), ("bar", {"elements": 4})]
)
def test_stored_results_are_reproduced(name, options):
    stored, now = load(name)[key(options)], measure.attempt(BY_NAME[name], options)
    assert now.failure == "" and now.unknowns == stored.unknowns
    assert now.values == pytest.approx(stored.values, rel=1e-6)
