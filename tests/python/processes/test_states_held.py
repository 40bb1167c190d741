"""A rope that the stabilisation could not let go of is held, and comes to rest at the strain that it is pulled to."""

from dataclasses import replace
from pathlib import Path

import pytest
from mpi4py import MPI

from braidx.processes.puller import HOLDABLE, RESTS, Puller
from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene
from braidx.solver.increment import Diverged

STRAND = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


@pytest.fixture
def model_and_state():
    scene = load_scene(STRAND, ["rope.pitches=1", "yarn.elements_per_pitch=20"])
    state = start_state(scene)
    return make_model(MPI.COMM_SELF, scene, state), state


def noted(model, monkeypatch, shares, fails=()):
    """Whether each increment may let go; those that may cannot, and hold shares of the energy."""
    asked, solve = [], model.incrementer.solve

    def held(start, guess, options, stiffening):
        asked.append(options.stabilisation is not None)
        if len(asked) in fails:
            raise Diverged("lost", 1, 1)
        found = solve(start, guess, replace(options, stabilisation=None), stiffening)
        work = shares[min(len(asked), len(shares)) - 1] * model.internal_energy(found.q)
        return replace(found, held=asked[-1], stabilisation_work=work)

    monkeypatch.setattr(model.incrementer, "solve", held)
    return asked


def test_it_is_held_until_little_is_left_and_for_the_rest_of_the_step(model_and_state, monkeypatch):
    model, state = model_and_state
    asked = noted(model, monkeypatch, [0.3, 0.05, 0.5 * HOLDABLE])
    puller = Puller(model, state)
    first = puller.to(5e-4)
    assert asked == [True, False, False]
    assert puller.strain == 5e-4 and puller.calming == 1.0
    left = 0.5 * HOLDABLE * model.internal_energy(puller.state.q)
    assert puller.state.stabilisation_work == pytest.approx(left)  # not of the way there
    assert first.increment.stabilisation_work == pytest.approx(left)
    puller.to(1e-3)
    assert asked[3:] == [False]
    assert puller.state.stabilisation_work > 1.9 * left
    assert "stuck" not in puller.state.next_step().progress


def test_what_is_found_at_once_needs_no_rest(model_and_state):
    model, state = model_and_state
    puller = Puller(model, state)
    assert not puller.to(5e-4).increment.held
    assert "stuck" not in puller.state.progress or not puller.state.progress["stuck"]


def test_a_rest_that_fails_is_tried_with_more_stabilisation(model_and_state, monkeypatch):
    model, state = model_and_state
    asked = noted(model, monkeypatch, [0.3, 0.3, 0.5 * HOLDABLE], fails=(2,))
    puller = Puller(model, state)
    viscosities, set_viscosity = [], model.set_viscosity
    monkeypatch.setattr(
        model, "set_viscosity", lambda *both: viscosities.append(both[0]) or set_viscosity(*both)
    )
    puller.to(5e-4)
    assert asked == [True, False, False]
    assert viscosities[2] == pytest.approx(4.0 * viscosities[1])


def test_a_rope_that_never_rests_is_told_by_its_work(model_and_state, monkeypatch):
    model, state = model_and_state
    asked = noted(model, monkeypatch, [0.3])
    puller = Puller(model, state)
    puller.to(5e-4)
    assert len(asked) == 1 + RESTS
    share = puller.state.stabilisation_work / model.internal_energy(puller.state.q)
    assert share == pytest.approx(0.3)
