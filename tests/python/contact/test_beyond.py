"""Nodes past the ends of a periodic sample."""

import numpy as np
import pytest

from braidx.contact.beyond import Beyond

BEYOND = 2


@pytest.fixture(params=[3, 9])
def tubes(request):
    """Two tubes of different lengths, and their unknowns."""
    block, num_nodes = request.param, np.array([6, 8])
    first = np.array([0, 6 * block])
    q = np.random.default_rng(0).standard_normal(int(num_nodes.sum()) * block)
    return Beyond.of(first, num_nodes, np.array([block, block]), BEYOND), q, num_nodes, block


def test_what_is_past_an_end_repeats_what_is_at_the_other(tubes):
    beyond, q, num_nodes, block = tubes
    seen = beyond.see(q)
    for tube, count in enumerate(num_nodes):
        own = q.reshape(-1, block)[num_nodes[:tube].sum() :][:count]
        first = beyond.first_unknown[tube] // block
        rows = seen.reshape(-1, block)[first - BEYOND : first + count + BEYOND]
        assert np.array_equal(rows[BEYOND:-BEYOND], own)
        period = np.zeros(block)
        period[2] = own[-1, 2] - own[0, 2]
        assert np.allclose(rows[:BEYOND], own[-1 - BEYOND : -1] - period)
        assert np.allclose(rows[-BEYOND:], own[1 : 1 + BEYOND] + period)


def test_forces_on_what_is_seen_do_the_same_work_on_the_unknowns(tubes):
    beyond, q, _, _ = tubes
    forces = np.random.default_rng(1).standard_normal(len(beyond.see(q)))
    residual = np.ones_like(q)
    beyond.give_back(forces, residual)
    assert (residual - 1.0) @ q == pytest.approx(forces @ beyond.see(q))
