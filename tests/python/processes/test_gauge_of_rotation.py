"""Ends that are alike let a rope rotate about its axis as a whole; that alone is held."""

from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.processes.start import in_own_model, make_model, start_state
from braidx.scene import load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


def ends_of(*options):
    """Ends of the small rope, placed, and its unknowns."""
    scene = load_scene(SMALL, [*options])
    model = make_model(MPI.COMM_SELF, scene, in_own_model(scene, start_state(scene)))
    return model.ends, model.start


def rotation(q, block):
    """What a rotation about the axis moves unknowns by, per radian."""
    vectors = q.reshape(-1, 3)
    return (vectors @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])).ravel()


def missed(ends, motion):
    """Largest part of a motion that the ends do not allow."""
    constraints, _ = ends.held(0.0)
    return np.abs(constraints.transform @ motion[constraints.free] - motion).max()


@pytest.mark.parametrize("symmetry", ["true", "false"])
@pytest.mark.parametrize("model", ["cable", "beam"])
def test_a_rotation_of_the_whole_rope_is_held(model, symmetry):
    ends, q = ends_of(f"yarn.model={model}", f"solver.symmetry={symmetry}")
    motion = rotation(q, ends.nodes.block)
    assert missed(ends, motion) > 0.1 * np.abs(motion).max()


def test_nothing_but_one_condition_is_added():
    ends, q = ends_of("solver.symmetry=false")
    free = len(ends.held(0.0)[0].free)
    num_yarns = len(ends.nodes.first)
    # Of each yarn the last node follows the first; one node stays along the axis, and there is the rotation.
    assert free == len(q) - 3 * num_yarns - 2
    shift = np.tile([1.0, 0.0, 0.0], len(q) // 3)
    tangential = q[ends.nodes.first + 1].sum()
    assert (
        abs(tangential) < 1e-9
    )  # the yarns stand evenly about the axis: shifts do not rotate them
    assert missed(ends, shift) < 1e-12


def test_ends_that_are_held_are_held_as_before():
    ends, _ = ends_of("solver.symmetry=false", 'ends.transverse="fixed"')
    assert ends.held(0.0)[0].held.sum() == 6 * len(ends.nodes.first)
