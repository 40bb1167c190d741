"""Where ropes of the papers are computed, and when: they take minutes. Puts their studies on the path."""

import os
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[2] / "studies"))
BEFOREHAND = "BRAIDX_PAPER_RUNS"  # folder of runs that are taken as they are, and added to


@pytest.fixture(scope="session")
def runs(request, tmp_path_factory):
    """Folder of the runs: an empty one unless told otherwise, as runs do not say which program they are of."""
    if not request.config.getoption("--papers"):
        pytest.skip("takes minutes: --papers, which ./braidx test --verification sets")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BRAIDX_THREADS", "1")
        given = os.environ.get(BEFOREHAND)
        yield Path(given).resolve() if given else tmp_path_factory.mktemp("paper_ropes")
