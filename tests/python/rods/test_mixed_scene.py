"""Beams, cables and solids in one scene, in contact, on one process and on two."""

import sys

import mixed_scene
import numpy as np
import pytest
import started


def test_beam_across_cables():
    rods = mixed_scene.pressed()
    total = sum(rods.reaction(rod, end)[0] for rod in (0, 1, 2) for end in (0, -1))
    contacts = rods.contacts()
    force = [contacts["normal_force"][contacts["tubes"][:, 1] == cable].sum() for cable in (1, 2)]
    assert force[0] > 10.0 and force[0] == pytest.approx(force[1], rel=1e-6)
    assert total == pytest.approx(np.zeros(3), abs=1e-6 * force[0])
    assert rods.reaction(0, 0)[0][2] == pytest.approx(-force[0], rel=0.02)
    assert rods.positions(1)[8, 2] < -0.1 and rods.directors(1).shape == (17, 0, 3)
    assert -contacts["gap"].min() <= 0.0101  # the default share of the radius


@started.needs_mpirun
def test_two_processes_find_what_one_does(tmp_path):
    path = tmp_path / "two.npz"
    done = started.run(sys.executable, mixed_scene.__file__, path, ranks=2)
    assert done.returncode == 0, done.stderr
    two = np.load(path)
    for name, value in mixed_scene.results().items():
        assert two[name] == pytest.approx(np.array(value), rel=1e-7, abs=1e-7), name
