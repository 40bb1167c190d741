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


@pytest.fixture(scope="session")
def ropes(runs):
    """Outcomes of all ropes of the papers, by study: all at once, as none of the tests is quick without them."""
    from paper_ropes import compute, paper_ropes

    return compute(runs, paper_ropes())
