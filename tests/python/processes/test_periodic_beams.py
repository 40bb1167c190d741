"""Ends of ropes of beams: where the rope goes on past them, its yarns have no hinges there."""

from pathlib import Path

import numpy as np
import pytest
from mpi4py import MPI

from braidx.processes.start import in_own_model, make_model, start_state
from braidx.scene import load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


def directors_at_ends(*options):
    """Directors of all yarns at both ends when nodes move at random as they may, and what they were at the start."""
    scene = load_scene(SMALL, ["yarn.model=beam", "solver.symmetry=false", *options])
    model = make_model(MPI.COMM_SELF, scene, in_own_model(scene, start_state(scene)))
    system = model.system
    free = system.free_values(model.start)
    moved = free + np.random.default_rng(2).standard_normal(len(free))
    ends = []
    for q in (system.expand(moved), model.start):
        yarns = q.reshape(len(model.rope.radius), -1, 9)
        ends.append(yarns[:, [0, -1], 3:])
    return ends


def test_sections_at_both_ends_turn_alike_where_the_rope_goes_on():
    now, start = directors_at_ends()
    assert np.abs(now - start).min() > 0.0
    assert now[:, 1] - now[:, 0] == pytest.approx(start[:, 1] - start[:, 0], abs=1e-12)


def test_sections_at_held_ends_are_free_or_held():
    now, start = directors_at_ends('ends.transverse="fixed"')
    assert np.abs((now - start)[:, 1] - (now - start)[:, 0]).min() > 0.0
    now, start = directors_at_ends('ends.transverse="fixed"', 'ends.sections="fixed"')
    assert now == pytest.approx(start, abs=1e-12)
