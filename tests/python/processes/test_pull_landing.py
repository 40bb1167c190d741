"""Pulling to a force: it is met, also by a rope that slips on the last increments."""

from dataclasses import dataclass, field
from types import SimpleNamespace

import pytest

from braidx.processes import pull

STIFFNESS = 1e7  # N


@dataclass(frozen=True)
class State:
    progress: dict = field(default_factory=dict)


@dataclass
class Slipping:
    """A puller of a rope that loses force in some of its increments."""

    slips: dict  # increment: loss of force, N
    strain: float = 0.0
    state: State = State()
    lost: float = 0.0
    done: int = 0

    def force(self):
        return STIFFNESS * self.strain - self.lost

    def to(self, strain):
        self.strain = strain
        self.done += 1
        self.lost += self.slips.get(self.done, 0.0)
        return SimpleNamespace(cuts=0)


@pytest.mark.parametrize("slips", [{}, {7: 400.0, 8: 500.0}, {7: 400.0, 8: 500.0, 9: 600.0}])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_force_is_met_by_a_rope_that_slips(slips, sense, monkeypatch):
    monkeypatch.setattr(
        pull, "outcome", lambda puller, attempt, share, name=None: (puller.force(), name)
    )
    target = sense * 70e3
    puller = Slipping({number: sense * loss for number, loss in slips.items()})
    found = list(pull._to_force(puller, target, 1e-3, "70 kN"))
    assert [name for _, name in found[:-1]] == [None] * (len(found) - 1)
    force, name = found[-1]
    missed = pull.LANDING * abs(target) + 0.5 * sum(map(abs, slips.values()))
    assert name == "70 kN" and abs(force - target) <= missed
    assert 7 <= len(found) <= 7 + 3 * len(slips)
