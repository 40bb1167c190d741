"""Groups of ends: placed where they belong, constrained as dense algebra says, the same on several processes."""

import sys
from pathlib import Path

import numpy as np
import pytest
import started
from end_bundle import CLAMP, MEAN_TURN, SIDE, TURN, bundle, last_ends, mean_rotation, run
from mpi4py import MPI

from braidx.geometry import build_rope, rotation_of
from braidx.processes.grouped_ends import check_ends
from braidx.processes.pull import hold
from braidx.processes.start import make_model, start_state
from braidx.scene import EndGroup, Hold, SceneError

FREE = {axis: "free" for axis in "xyz"}
SWIVEL = EndGroup(end="last", level="rope", rigid=True, rotation={"z": "free"})


def model_of(*groups, **options):
    scene = bundle(*groups, **options)
    return make_model(MPI.COMM_SELF, scene, start_state(scene))


def shaken(model, size=0.02, seed=1):
    return model.start + size * np.random.default_rng(seed).standard_normal(len(model.start))


def distances(points):
    return np.linalg.norm(points[:, None] - points[None], axis=2)


@pytest.mark.parametrize("turn", [30.0, 400.0])
def test_a_body_is_placed_exactly_rigid_and_turned_any_number_of_times(turn):
    body = EndGroup(
        end="last", level="rope", rigid=True, rotation={"z": turn}, displacement=FREE | {"z": 0.5}
    )
    model = model_of(CLAMP, body)
    placed = model.ends.place(shaken(model), 0.01, 0.5)
    start, now = last_ends(model, model.start), last_ends(model, placed)
    np.testing.assert_allclose(distances(now), distances(start), atol=1e-12)
    exact = (start - start.mean(axis=0)) @ rotation_of(np.radians([0.0, 0.0, turn / 2])).T
    np.testing.assert_allclose(now - now.mean(axis=0), exact, atol=1e-12)
    assert now[:, 2].mean() == pytest.approx(40.0 * 1.01 + 0.25)


def test_means_are_met_by_all_states_that_the_constraints_allow():
    """Among these are states in which single ends are anywhere."""
    model = model_of(CLAMP, MEAN_TURN)
    placed = model.ends.place(shaken(model), 0.01, 1.0)
    constraints, values = model.ends.held(0.01, 1.0, placed)
    free = placed[constraints.free]
    found = last_ends(model, constraints.expand(free, values))
    assert found[:, :2] == pytest.approx(last_ends(model, placed)[:, :2], abs=1e-12)
    wild = free + 0.1 * np.random.default_rng(2).standard_normal(len(free))
    q = constraints.expand(wild, values)
    assert mean_rotation(model, q)[2] == pytest.approx(TURN, abs=1e-9)
    moved = last_ends(model, q) - last_ends(model, model.start)
    assert moved[:, :2].mean(axis=0) == pytest.approx([0.0, 0.0], abs=1e-12)
    assert moved[:, 2] == pytest.approx(0.4)  # one plane: no group is responsible for z


def test_constraints_of_a_body_are_its_small_motions():
    """Against the dense projection on translations and rotations about the centroid."""
    model = model_of(CLAMP, SWIVEL)
    placed = model.ends.place(shaken(model), 0.0, 1.0)
    constraints, _ = model.ends.held(0.0, 1.0, placed)
    unknowns = (model.ends.nodes.last[:, None] + np.arange(3)).ravel()
    rows = constraints.transform[unknowns].toarray()
    moving = rows[:, np.abs(rows).max(axis=0) > 0]
    arms = last_ends(model, placed) - last_ends(model, placed).mean(axis=0)
    turning = np.cross([0.0, 0.0, 1.0], arms).ravel()
    assert moving.shape[1] == 1
    np.testing.assert_allclose(
        moving[:, 0] / np.linalg.norm(moving), turning / np.linalg.norm(turning), atol=1e-12
    )


def test_moment_and_force_act_as_such_on_a_group_that_is_not_rigid():
    loaded = EndGroup(
        end="last", level="rope", force={"x": 0.2, "z": 1.0}, moment={"z": 500.0, "x": 30.0}
    )
    model = model_of(CLAMP, loaded, steps=(Hold(),))
    q = shaken(model)
    loads, ends = last_ends(model, model.ends.loads(q, 0.5)), last_ends(model, q)
    assert loads.sum(axis=0) == pytest.approx([100.0, 0.0, 500.0])
    moment = np.cross(ends - ends.mean(axis=0), loads).sum(axis=0)
    assert moment == pytest.approx([15.0, 0.0, 250.0], abs=1e-9)


@pytest.mark.parametrize("model", ["cable", "beam"])
def test_mean_rotation_is_what_was_asked_for_while_single_ends_rearrange(model):
    rope, outcomes = run(bundle(CLAMP, MEAN_TURN, SIDE, model=model))
    q = outcomes[-1].state.q
    assert mean_rotation(rope, q)[2] == pytest.approx(TURN, abs=1e-8)
    moved = last_ends(rope, q) - last_ends(rope, rope.start)
    assert moved[:, :2].mean(axis=0) == pytest.approx([0.0, 0.0], abs=1e-10)
    ends = last_ends(rope, q)[:, :2]
    ends -= ends.mean(axis=0)
    radii = np.linalg.norm(ends, axis=1)[1:]
    assert radii.max() > 1.2 and radii.min() < 1.0  # 1.1 in the beginning
    assert outcomes[-1].moment > 50.0 and outcomes[-1].strain == pytest.approx(0.01)


def test_a_turn_goes_on_from_a_state_in_its_middle():
    scene = bundle(CLAMP, MEAN_TURN)
    _, outcomes = run(scene)
    middle, end = outcomes[-8].state, outcomes[-1]
    again = list(hold(make_model(MPI.COMM_SELF, scene, middle), middle, scene.steps[1]))
    assert len(again) == 7
    assert again[-1].state.q == pytest.approx(end.state.q, abs=1e-9)
    assert again[-1].moment == pytest.approx(end.moment, rel=1e-7)


def test_a_mean_that_is_given_already_is_refused_before_anything_is_computed():
    strands = EndGroup(end="last", level="strand", displacement={"x": "held"})
    scene = bundle(CLAMP, MEAN_TURN, strands)
    with pytest.raises(SceneError, match=r"ends.groups\[.\]: asks for what is given by other"):
        check_ends(scene, build_rope(scene))


@started.needs_mpirun
def test_two_processes_find_what_one_does(tmp_path):
    results = []
    for ranks in (1, 2):
        path = tmp_path / f"{ranks}.npz"
        script = Path(__file__).with_name("end_bundle.py")
        done = started.run(sys.executable, script, path, ranks=ranks)
        assert done.returncode == 0, done.stderr
        results.append(np.load(path))
    one, two = results
    np.testing.assert_allclose(two["q"], one["q"], atol=1e-9)
    for name in ("force", "moment"):
        assert two[name] == pytest.approx(one[name], rel=1e-9)
