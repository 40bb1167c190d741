"""A sheave that turns as the rope takes it along."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from braidx.processes.bending.bearing import BALANCED, MOST, balanced
from braidx.solver.trial import Diverged

SCENE = Path(__file__).parent / "small_bend.toml"


@pytest.mark.parametrize("rest", [0.0, 1e-4, -0.03, 0.7])
def test_balance_of_friction_that_slides_away_from_it(rest):
    """Friction is elastic within 1e-3 radians of the balance, and a constant moment of 50 beyond."""
    tried = []

    def solve(turn):
        tried.append(turn)
        return SimpleNamespace(q=turn, iterations=1, linear_solves=1)

    def moment(increment):
        return 50.0 * np.clip((increment.q - rest) / 1e-3, -1.0, 1.0), 50.0 * BALANCED

    increment, turn = balanced(solve, moment, 0.0, 1e-3)
    assert turn == pytest.approx(rest, abs=1.01 * BALANCED * 1e-3)
    assert increment.q == turn == tried[-1]
    assert len(tried) <= MOST


def test_no_balance_is_said_to_be_none():
    def solve(turn):
        return SimpleNamespace(q=turn, iterations=3, linear_solves=4)

    with pytest.raises(Diverged, match="the sheave finds no balance: 5 N mm are left"):
        balanced(solve, lambda increment: (5.0, 0.1), 0.0, 1e-3)


def test_a_rope_over_a_free_sheave(run, tmp_path):
    """Both ends move alike: the sheave turns a little, as the helices of the two directions are not mirror images."""
    words = ["sheave.motion=free", "steps.bend.travel=2"]
    free = run(tmp_path / "free", *(part for w in words for part in ("--set", w)), scene=SCENE)
    assert free.code == 0, free.stderr
    assert 0.0 < abs(free.values["sheave_angle"]) < 5.0
    assert free.values["relative_displacement"] > 0.05
    assert free.history["Newton iterations"].max() > 30  # of all turns that were tried
