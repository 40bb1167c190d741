"""Beams, cables and solids in one scene, in contact, on one process and on two."""

import os
import shutil
import subprocess
import sys

import mixed_scene
import numpy as np
import pytest


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


@pytest.mark.skipif(shutil.which("mpirun") is None, reason="needs mpirun")
def test_two_processes_find_what_one_does(tmp_path):
    path = tmp_path / "two.npz"
    words = [
        "mpirun",
        "--oversubscribe",
        "-n",
        "2",
        sys.executable,
        mixed_scene.__file__,
        str(path),
    ]
    environment = os.environ | {
        "OMPI_MCA_btl": "self,sm",
        "OMPI_MCA_mpi_yield_when_idle": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "BRAIDX_THREADS": "1",
    }
    done = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    two = np.load(path)
    for name, value in mixed_scene.results().items():
        assert two[name] == pytest.approx(np.array(value), rel=1e-7, abs=1e-7), name
