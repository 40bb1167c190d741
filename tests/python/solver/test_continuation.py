"""Increments by pseudo-transient continuation: consistent pairs at their end, or a clean way back."""

import numpy as np
import pytest
from test_increment import same, short_strand

from braidx.solver.increment import IncrementOptions
from braidx.solver.trial import Diverged


def pull(model, q, strain, options=IncrementOptions()):
    """One increment to a strain, started from an even stretch."""
    system = model.system
    system.constraints, system.constraint_values = model.ends.held(strain)
    stretched = q.reshape(-1, model.body.block).copy()
    stretched[:, 2] = (1 + strain) * model.start.reshape(stretched.shape)[:, 2]
    guess = system.expand(system.free_values(stretched.ravel()))
    model.measure(float(np.mean(model.tension(guess))))
    return model.continuation.solve(q, guess, options)


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("model_name", ["cable", "beam"])
def test_forces_are_in_balance_and_fresh_pairs_leave_them_so(model_name, friction):
    model, q = short_strand(f"yarn.model={model_name}", f"contact.friction={friction}")
    most = model.scene.solver.tolerance
    for strain in (1e-3, 2e-3):
        increment = pull(model, q, strain)
        q = increment.q
        assert increment.residual < most
        assert increment.iterations <= 15
    model.set_viscosity(0.0)  # what acts is contact and the yarns alone
    assert model.newton.residual(q) < most
    model.contact.update(q)
    assert model.newton.residual(q) < IncrementOptions().pairing_tolerance
    assert model.axial_force(q) > 100.0


def test_the_state_found_does_not_depend_on_the_metric():
    """But for friction, which has a path."""
    found = []
    for scale in (0.2, 5.0):
        model, q = short_strand("contact.friction=0.0")
        measure = model.measure
        model.measure = lambda tension, scale=scale, measure=measure: measure(scale * tension)
        found.append(pull(model, q, 1e-3).q)
    # The end is moved by 0.066 mm; a residual at the tolerance leaves 1e-5 mm open.
    assert np.abs(found[0] - found[1]).max() < 3e-5


def test_penalties_are_raised_until_penetrations_are_tolerable():
    model, q = short_strand()
    model.contact.pairing.stiffness = 30.0
    wanted = pull(model, q, 5e-3).penetration / 5
    model, q = short_strand()
    model.contact.pairing.stiffness = 30.0
    increment = pull(model, q, 5e-3, IncrementOptions(penetration=wanted))
    assert 0 < increment.penetration <= wanted
    assert model.contact.arrays()["stiffness"].max() > 30.0


def test_a_failed_increment_leaves_no_trace():
    model, q = short_strand()
    q = pull(model, q, 2e-3).q
    before, kept = model.contact.arrays(), q.copy()
    model.continuation.most_steps = 2
    with pytest.raises(Diverged, match="after 2 steps") as failure:
        pull(model, q, 5e-2, IncrementOptions(pairing_tolerance=0.0))
    assert same(model.contact.arrays(), before) and np.array_equal(q, kept)
    assert failure.value.iterations == failure.value.linear_solves == 2
    assert failure.value.deepest != "none"  # of the state that was tried, before the way back


def test_the_way_back_leads_on():
    """After a failure the next increment is the one that would have been without it."""
    results = []
    for fails in (False, True):
        model, q = short_strand()
        q = pull(model, q, 1e-3).q
        if fails:
            most, model.continuation.most_steps = model.continuation.most_steps, 1
            with pytest.raises(Diverged):
                pull(model, q, 3e-2)
            model.continuation.most_steps = most
        results.append(pull(model, q, 2e-3))
    assert np.abs(results[0].q - results[1].q).max() < 1e-9
    assert results[0].friction_work == pytest.approx(results[1].friction_work, rel=1e-6)
