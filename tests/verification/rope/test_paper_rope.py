"""R4 and R5: paper 1's rope, judged from a run of demos/tensile_test.toml made beforehand.

The run takes minutes: name its output folder in BRAIDX_TENSILE_TEST to have it judged.
"""

import json
import os
from pathlib import Path

import pytest

FOLDER = os.environ.get("BRAIDX_TENSILE_TEST")
EXACT = {  # value, relative tolerance
    "rope_axial_stiffness": (9512.0, 0.10),  # kN
    "efficiency": (0.699, 0.10),
    "outer_diameter_formed": (20.0, 0.05),  # mm
    "outer_diameter_loaded": (19.0, 0.05),  # mm, at 70 kN
}
LIMITS = {
    "wrong_side_crossings": 0,
    "max_penetration_over_radius": 0.02,
    "stabilisation_work_share": 0.01,
}


@pytest.fixture(scope="module")
def results():
    if not FOLDER:
        pytest.skip("BRAIDX_TENSILE_TEST names no run of demos/tensile_test.toml")
    summary = json.loads((Path(FOLDER) / "summary.json").read_text("utf-8"))
    assert summary["converged"]
    return {name: result["value"] for name, result in summary["results"].items()}


@pytest.mark.parametrize("name", EXACT)
def test_result(results, name):
    value, tolerance = EXACT[name]
    assert results[name] == pytest.approx(value, rel=tolerance)


@pytest.mark.parametrize("name", LIMITS)
def test_limit(results, name):
    assert 0 <= results[name] <= LIMITS[name]
