"""Increments on the way: cut where none is found, grown again, given up in the end."""

from types import SimpleNamespace

import numpy as np
import pytest

from braidx.rods import NotConverged
from braidx.rods.path import follow
from braidx.solver.trial import Diverged

START = np.zeros(2)


class Way:
    """A fake of equilibria: the state is the share, and increments across `bar` must not be longer than `longest`."""

    def __init__(self, bar=2.0, longest=1.0):
        self.bar, self.longest = bar, longest
        self.asked, self.accepted, self.predicted = [], [], []

    def step(self, begin, end, before):
        self.asked.append(end)
        if begin < self.bar <= end + 1e-12 and end - begin > self.longest:
            raise Diverged("too long", 1, 1)
        self.predicted.append(before[0])
        return SimpleNamespace(q=np.array([end, 0.0]))

    def go(self, increments=4, max_cuts=3):
        return follow(self.step, START, increments, max_cuts, self.accept)

    def accept(self, increment, share):
        assert increment.q[0] == share
        self.accepted.append(share)


def test_equal_increments():
    way = Way()
    assert len(way.go()) == 4
    assert way.accepted == pytest.approx([0.25, 0.5, 0.75, 1.0])
    assert way.accepted[-1] == 1.0
    assert way.predicted == pytest.approx([0.0, 0.25, 0.25, 0.25])  # at the pace of the last


def test_an_increment_is_cut_and_the_pace_forgotten():
    way = Way(bar=0.5, longest=0.1)
    way.go()
    assert way.asked[:4] == pytest.approx([0.25, 0.5, 0.375, 0.5])
    assert way.accepted[-1] == 1.0 and np.all(np.diff([0.0, *way.accepted]) > 0)
    first_after_cut = way.predicted[1]
    assert first_after_cut == 0.0


def test_increments_grow_again():
    way = Way(bar=0.1, longest=0.1)
    way.go(increments=2, max_cuts=4)
    steps = np.diff([0.0, *way.accepted])
    assert steps[0] == pytest.approx(0.0625)
    assert steps.max() >= 0.25
    assert way.accepted[-1] == 1.0


def test_whole_increments_end_where_they_would_have():
    """Halved ones are doubled only where the places of the longer ones are met again."""
    way = Way(bar=0.3, longest=0.2)
    way.go(increments=4)
    assert np.any(np.isclose(way.accepted, 0.5)) and np.any(np.isclose(way.accepted, 0.75))


def test_giving_up_tells_how_far_it_got():
    way = Way(bar=0.6, longest=0.0)
    with pytest.raises(NotConverged) as caught:
        way.go(increments=4, max_cuts=2)
    message = str(caught.value)
    assert "0.625 of the way, after 3 increments: too long" in message
    assert isinstance(caught.value.__cause__, Diverged)
    assert way.accepted == pytest.approx([0.25, 0.5, 0.5625])
