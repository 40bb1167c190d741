"""Several ranks give the numbers of one, whether curves and parts are dealt out whole or cut."""

import sys
from pathlib import Path

import numpy as np
import pytest
import started

FOLDER = Path(__file__).parent


@started.needs_mpirun
@pytest.mark.parametrize("script", ["parallel_state.py", "parallel_solid_state.py"])
@pytest.mark.parametrize("ranks", [2, 3])
def test_ranks_agree_with_one(ranks, script, tmp_path):
    results = []
    for size in (1, ranks):
        path = tmp_path / f"{size}.npz"
        done = started.run(sys.executable, FOLDER / script, path, ranks=size)
        assert done.returncode == 0, done.stderr
        results.append(np.load(path))
    one, many = results
    assert set(one.files) == set(many.files)
    for name in one.files:
        assert np.abs(one[name] - many[name]).max() < 1e-12 * np.abs(one[name]).max(), name
