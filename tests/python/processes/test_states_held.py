"""A rope that the stabilisation could not let go of is held, and comes to rest at the strain that it is pulled to."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.processes.outcome import NotConverged
from braidx.processes.puller import HOLDABLE, LOST, Puller
from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene

STRAND = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


@pytest.fixture
def model_and_state():
    scene = load_scene(STRAND, ["rope.pitches=1", "yarn.elements_per_pitch=20"])
    state = start_state(scene)
    return make_model(MPI.COMM_SELF, scene, state), state


def noted(model, monkeypatch, shares, works=None):
    """Whether each increment may let go; those that may cannot, and hold shares of the energy."""
    asked, solve = [], model.incrementer.solve

    def held(start, guess, options, stiffening):
        asked.append(options.stabilisation is not None)
        found = solve(start, guess, replace(options, stabilisation=None), stiffening)
        work = shares[min(len(asked), len(shares)) - 1] * model.internal_energy(found.q)
        if works is not None:
            works.append(work)
        return replace(found, held=asked[-1], stabilisation_work=work, stabilisation_residual=work)

    monkeypatch.setattr(model.incrementer, "solve", held)
    return asked


def test_it_is_held_until_little_is_left_and_for_the_rest_of_the_step(model_and_state, monkeypatch):
    model, state = model_and_state
    works: list[float] = []
    asked = noted(model, monkeypatch, [0.02, 0.005, 0.5 * HOLDABLE], works)
    puller = Puller(model, state)
    first = puller.to(5e-4)
    assert asked == [True, False, False]
    assert puller.strain == 5e-4 and puller.calming == 1.0
    left = 0.5 * HOLDABLE * model.internal_energy(puller.state.q)
    assert puller.state.stabilisation_residual == pytest.approx(left)
    assert puller.state.stabilisation_work == pytest.approx(sum(works))  # the way there, too
    assert works[-1] == pytest.approx(left) and works[0] > 20 * left
    assert first.increment.stabilisation_work == puller.state.stabilisation_work
    puller.to(1e-3)
    assert asked[3:] == [False]
    assert puller.state.stabilisation_residual > 1.9 * left
    assert "stuck" not in puller.state.next_step().progress


def test_what_is_found_at_once_needs_no_rest(model_and_state):
    model, state = model_and_state
    puller = Puller(model, state)
    assert not puller.to(5e-4).increment.held
    assert not puller.state.progress["stuck"]


@pytest.mark.parametrize("share", [1.2 * HOLDABLE, 0.6 * LOST])
def test_a_rope_that_does_not_rest_is_no_result(model_and_state, monkeypatch, share):
    """Nor is one that gives way by more than may be lost; its state and contacts are those of before."""
    model, state = model_and_state
    noted(model, monkeypatch, [share])
    puller, before = Puller(model, state), model.contact.arrays()
    with pytest.raises(NotConverged, match="is lost at rest" if share > 0.02 else "come to rest"):
        puller.to(5e-4)
    assert puller.strain == 0.0 and puller.calming == 1.0 and puller.state is state
    after = model.contact.arrays()
    assert all(np.array_equal(after[name], before[name]) for name in before)


def test_forces_that_hold_a_rope_are_told_from_none(model_and_state):
    model, state = model_and_state
    puller = Puller(model, state)
    found = puller.to(5e-4).increment
    assert puller.is_at_rest(found)
    moved = found.q + 1e-4 * np.sin(np.arange(found.q.size))
    assert not puller.is_at_rest(replace(found, q=moved))
