"""Pulling to a force: it is met, also by a rope that slips on the last increments."""

from dataclasses import dataclass, field
from types import SimpleNamespace

import pytest

from braidx.processes import pull
from braidx.processes.outcome import NotConverged
from braidx.processes.puller import Puller
from braidx.scene import Pull
from braidx.solver.increment import Diverged

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

    def to(self, strain, part=1.0):
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


class Stuck(Puller):
    """A rope that has no equilibrium beyond a strain: what goes less than half of the way there is found."""

    def __init__(self, end, max_cuts):
        solver = SimpleNamespace(max_cuts=max_cuts)
        self.model = SimpleNamespace(scene=SimpleNamespace(solver=solver))
        self.strain, self.share, self.end, self.state = 0.0, 0.0, end, State()

    def _increment(self, strain, share):
        if strain > (self.strain + self.end) / 2.0:
            raise Diverged("no equilibrium", 1, 1)
        return SimpleNamespace(iterations=1, linear_solves=1)

    def _take(self, increment, strain, share):
        self.strain = strain

    def _give_up(self, strain, failure):
        return NotConverged(f"stuck at {strain}")


@pytest.mark.parametrize("max_cuts", [2, 4, 8])
def test_increments_that_are_halved_again_and_again_end(max_cuts, monkeypatch):
    """A braid that was pushed crept towards a strain that it never came to, in ever smaller increments."""
    monkeypatch.setattr(pull, "Puller", lambda model, state: state)
    monkeypatch.setattr(pull, "outcome", lambda puller, *rest: puller.strain)
    stuck, found = Stuck(0.7e-3, max_cuts), []
    with pytest.raises(NotConverged):
        for strain in pull.pull(None, stuck, Pull(to_strain=0.01, strain_increment=1e-3)):
            found.append(strain)
    assert len(found) <= 6 * max_cuts
    assert 0.7e-3 - stuck.strain < 1e-3 / 2 ** (max_cuts - 1)
