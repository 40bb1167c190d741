"""Several ranks give the numbers of one, whether curves and parts are dealt out whole or cut."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parent


@pytest.mark.skipif(shutil.which("mpirun") is None, reason="needs mpirun")
@pytest.mark.parametrize("script", ["parallel_state.py", "parallel_solid_state.py"])
@pytest.mark.parametrize("ranks", [2, 3])
def test_ranks_agree_with_one(ranks, script, tmp_path):
    results = []
    for size in (1, ranks):
        path = tmp_path / f"{size}.npz"
        command = [
            "mpirun",
            "--oversubscribe",
            "-n",
            str(size),
            sys.executable,
            str(FOLDER / script),
        ]
        environment = os.environ | {"OMPI_MCA_btl": "self,sm"}
        done = subprocess.run(
            [*command, str(path)], env=environment, capture_output=True, text=True, timeout=120
        )
        assert done.returncode == 0, done.stderr
        results.append(np.load(path))
    one, many = results
    assert set(one.files) == set(many.files)
    for name in one.files:
        assert np.abs(one[name] - many[name]).max() < 1e-12 * np.abs(one[name]).max(), name
