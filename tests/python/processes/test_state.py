"""Checkpoints: what is saved is what is loaded, and an interruption leaves the one before whole."""

from dataclasses import replace

import numpy as np
import pytest

from braidx.output.summary import PhaseCost
from braidx.processes import state as checkpoint
from braidx.processes.state import State
from braidx.scene import SceneError


@pytest.fixture
def some_state():
    rng = np.random.default_rng(0)
    return State(
        q=rng.standard_normal(12),
        model="cable",
        reference=rng.standard_normal(12),
        rest_tension=rng.standard_normal(3),
        previous=rng.standard_normal(12),
        stretches=np.array([[0, 1, 0, 4], [1, 2, 0, 4]]),
        contacts={"slip": rng.standard_normal((2, 3)), "station": np.array([4, 2**63 - 1])},
        step=2,
        progress={"strain": 1 / 3, "size": 1e-3},
        increment=7,
        results={"friction_work": 0.1, "wrong_side_crossings": 0.0},
        costs={"form": PhaseCost(1.5, 3, 20, 21)},
        stabilisation_work=0.1 + 0.2,
        friction_work=1e-300,
    )


def test_round_trip(some_state, tmp_path):
    checkpoint.save(some_state, tmp_path)
    loaded = checkpoint.load(tmp_path)
    assert loaded is not None
    for name in checkpoint.ARRAYS:
        np.testing.assert_array_equal(getattr(loaded, name), getattr(some_state, name))
    for name, values in some_state.contacts.items():
        np.testing.assert_array_equal(loaded.contacts[name], values)
        assert loaded.contacts[name].dtype == values.dtype
    plain = {**dict.fromkeys(checkpoint.ARRAYS, 0), "contacts": {}}
    assert replace(loaded, **plain) == replace(some_state, **plain)


def test_an_empty_folder_has_no_state(tmp_path):
    assert checkpoint.load(tmp_path) is None


def test_a_damaged_checkpoint_is_refused(tmp_path):
    (tmp_path / checkpoint.FILE).write_bytes(b"not a checkpoint")
    with pytest.raises(SceneError, match="cannot be read"):
        checkpoint.load(tmp_path)


def test_an_interrupted_save_leaves_the_one_before(some_state, tmp_path, monkeypatch):
    checkpoint.save(some_state, tmp_path)

    def interrupted(*arguments, **arrays):
        raise KeyboardInterrupt

    monkeypatch.setattr(np, "savez", interrupted)
    with pytest.raises(KeyboardInterrupt):
        checkpoint.save(replace(some_state, increment=8), tmp_path)
    loaded = checkpoint.load(tmp_path)
    assert loaded is not None and loaded.increment == 7


def test_the_next_step_goes_on_from_the_strain(some_state):
    following = some_state.next_step()
    assert (following.step, following.progress) == (3, {"strain": 1 / 3})
    assert some_state.step == 2
