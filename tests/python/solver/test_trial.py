"""Damping of contact updates that do not approach each other."""

import numpy as np
import pytest

from braidx.solver.trial import FIRST_DAMPING, MOST_DAMPING, PATIENCE, Diverged, Trial


def dampings(slow):
    """Of the updates after each judgement."""
    trial = Trial(np.zeros(3), loose=False)
    found = []
    for judgement in slow:
        trial.judge(judgement)
        found.append(trial.damping)
    return found


def test_slow_updates_are_damped_more_and_more():
    assert dampings([False, True, True, True, True]) == pytest.approx(
        [0.0, FIRST_DAMPING, 2 * FIRST_DAMPING, MOST_DAMPING, MOST_DAMPING]
    )


def test_damping_fades():
    assert dampings([True, False, False]) == pytest.approx(
        [FIRST_DAMPING, FIRST_DAMPING / 2, FIRST_DAMPING / 4]
    )


def test_damping_is_lifted_once_in_a_while_and_ever_less_often():
    """Else what is easily moved would creep for ever: an update without damping takes it where it belongs."""
    lifted = np.flatnonzero(np.array(dampings([True] * 40)) == 0.0)
    assert lifted.tolist() == [PATIENCE, 3 * PATIENCE + 1, 7 * PATIENCE + 2]


def test_pairs_of_a_failure_are_told_by_their_numbers():
    failure = Diverged("lost", 3, 4)
    assert failure.deepest == "none"
    failure.pairs = [(4, 7), (2, -1), (2, -2)]
    assert failure.deepest == "4-7, 2-rigid"


def test_updates_in_vain_are_counted_from_the_least_residual_on():
    trial, counts = Trial(np.zeros(3), loose=False), []
    for residual, anew in [(0.5, False), (0.6, False), (0.4, False), (0.4, False), (0.9, True)]:
        trial.residual = residual
        trial.note(anew)
        counts.append(trial.in_vain)
    assert counts == [0, 1, 0, 1, 0]
    trial.residual = 0.8  # what came before the change does not count
    trial.note(False)
    assert trial.in_vain == 0
