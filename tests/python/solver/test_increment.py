"""Increments: consistent pairs at their end, penetrations within tolerance, or a clean way back."""

from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.processes.start import make_model, start_state
from braidx.scene import load_scene
from braidx.solver.increment import Diverged, IncrementOptions
from braidx.solver.newton import NewtonResult

STRAND = Path(__file__).parents[3] / "demos" / "twisted_strand.toml"


def short_strand(*overrides):
    """A short strand at rest, and its first state."""
    small = ["rope.pitches=1", "yarn.elements_per_pitch=20", "contact.friction=0.3"]
    scene = load_scene(STRAND, [*small, *overrides])
    state = start_state(scene)
    model = make_model(MPI.COMM_SELF, scene, state)
    model.set_viscosity(scene.solver.viscosity, scene.solver.director_viscosity)
    return model, state.q


def pull(model, q, strain, options=IncrementOptions()):
    """One increment to a strain, started from an even stretch."""
    system = model.system
    system.constraints, system.constraint_values = model.ends.held(strain)
    stretched = q.reshape(-1, model.body.block).copy()
    stretched[:, 2] = (1 + strain) * model.start.reshape(stretched.shape)[:, 2]
    guess = system.expand(system.free_values(stretched.ravel()))
    return model.incrementer.solve(q, guess, options)


def same(arrays, others):
    return arrays.keys() == others.keys() and all(
        np.array_equal(arrays[name], others[name]) for name in arrays
    )


@pytest.mark.parametrize("model_name", ["cable", "beam"])
def test_fresh_pairs_leave_an_equilibrium_alone(model_name):
    model, q = short_strand(f"yarn.model={model_name}")
    tolerance = IncrementOptions().pairing_tolerance
    for strain in (1e-3, 2e-3):
        increment = pull(model, q, strain)
        q = increment.q
        assert increment.residual < tolerance
    model.contact.start = q  # the memory of friction holds the forces
    model.contact.update(q)
    assert model.newton.residual(q) < 2 * tolerance
    assert increment.updates >= 1 and increment.iterations >= increment.updates
    assert model.axial_force(q) > 100.0


def test_penalties_are_raised_until_penetrations_are_tolerable():
    model, q = short_strand()
    model.contact.pairing.stiffness = 30.0
    soft = pull(model, q, 5e-3)
    wanted = soft.penetration / 5
    model, q = short_strand()
    model.contact.pairing.stiffness = 30.0
    increment = pull(model, q, 5e-3, IncrementOptions(penetration=wanted))
    assert 0 < increment.penetration <= wanted
    assert model.contact.arrays()["stiffness"].max() > 30.0


@pytest.mark.parametrize("limit", ["iterations", "updates"])
def test_a_failed_increment_leaves_no_trace(limit):
    model, q = short_strand()
    q = pull(model, q, 2e-3).q
    before, kept = model.contact.arrays(), q.copy()
    work = before["work"].sum()
    if limit == "iterations":
        model.newton.max_iterations = 0
        options = IncrementOptions()
    else:
        options = IncrementOptions(pairing_tolerance=0.0, max_updates=2)
    with pytest.raises(Diverged) as failure:
        pull(model, q, 5e-2, options)
    assert same(model.contact.arrays(), before)
    assert np.array_equal(q, kept) and model.contact.arrays()["work"].sum() == work
    assert not model.proximal.damping.any()
    assert (failure.value.iterations > 0) == (limit == "updates")
    assert failure.value.deepest != "none"  # of the state that was tried, before the way back


def test_the_way_back_leads_on():
    """After a failure the next increment is the one that would have been without it."""
    results = []
    for fails in (False, True):
        model, q = short_strand()
        q = pull(model, q, 1e-3).q
        if fails:
            with pytest.raises(Diverged):
                pull(model, q, 3e-2, IncrementOptions(pairing_tolerance=0.0, max_updates=1))
        results.append(pull(model, q, 2e-3))
    assert np.abs(results[0].q - results[1].q).max() < 1e-9
    assert results[0].friction_work == pytest.approx(results[1].friction_work, rel=1e-6)


def lose_newton_at_first(model, monkeypatch):
    """Newton's first solve leads nowhere; the dampings of all solves."""
    solve, dampings = model.newton.solve, []

    def lost_at_first(start, enough, search):
        dampings.append(model.proximal.damping.max())
        if len(dampings) == 1:
            assert not search
            return start + 1.0, NewtonResult(False, 7, 7, 9.0, "diverged local min")
        return solve(start, enough, search)

    monkeypatch.setattr(model.newton, "solve", lost_at_first)
    return dampings


def test_a_loose_rope_is_held_where_newton_gets_lost(monkeypatch):
    """The hold does not act on the equilibrium, and fades."""
    free = pull(*short_strand("contact.friction=0.0"), 1e-3)
    model, q = short_strand("contact.friction=0.0")
    model.incrementer.hold = hold = 300.0
    dampings = lose_newton_at_first(model, monkeypatch)
    held = pull(model, q, 1e-3)
    assert dampings[:3] == pytest.approx([0.0, hold, hold / 2])
    assert held.updates > free.updates and held.iterations > 7
    assert held.residual < IncrementOptions().pairing_tolerance
    assert np.abs(held.q - free.q).max() < 2e-4


def test_a_loose_rope_that_no_hold_helps_has_no_equilibrium(monkeypatch):
    model, q = short_strand()
    model.incrementer.hold = 300.0
    dampings = []

    def lost(start, enough, search):
        dampings.append(model.proximal.damping.max())
        return start, NewtonResult(False, 7, 7, 9.0, "diverged local min")

    monkeypatch.setattr(model.newton, "solve", lost)
    with pytest.raises(Diverged, match="no convergence"):
        pull(model, q, 1e-3)
    assert dampings[:4] == pytest.approx([0.0, 300.0, 1200.0, 4800.0])


def test_a_rope_under_load_is_not_held():
    model, q = short_strand()
    model.incrementer.hold = 1e-3
    q = pull(model, q, 1e-3).q
    searched = []
    solve = model.newton.solve
    model.newton.solve = lambda *given, search: searched.append(search) or solve(*given, search)
    pull(model, q, 2e-3)
    assert searched and all(searched)


def test_stabilisation_works_on_departures_from_the_guess():
    model, q = short_strand()
    increment = pull(model, q, 1e-3)
    moved = increment.q - model.proximal.start
    turned = model.proximal.turning.work(moved)
    assert turned > 0
    expected = model.proximal.viscosity @ moved**2 + turned
    assert increment.stabilisation_work == pytest.approx(expected)
    model.set_viscosity(0.0)
    assert model.proximal.work(increment.q) == 0.0


def test_updates_that_come_no_nearer_end_the_increment():
    model, q = short_strand()
    options = IncrementOptions(pairing_tolerance=0.0, max_updates=30, most_in_vain=2)
    with pytest.raises(Diverged) as failure:
        pull(model, q, 1e-3, options)
    assert 2 < int(str(failure.value).split("after ")[1].split()[0]) < 30
