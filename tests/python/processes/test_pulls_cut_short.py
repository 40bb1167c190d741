"""Results of pulls that ended early: what there is of them."""

import numpy as np
import pytest

from braidx.geometry import build_rope
from braidx.processes.measurements import final_results
from braidx.scene import load_scene
from runs import SMALL


@pytest.mark.parametrize("force, has_stiffness", [([1.0, 5.0], False), ([1.0, 4.0, 5.0], True)])
def test_a_pull_without_a_linear_part_has_no_stiffness(force, has_stiffness):
    scene = load_scene(SMALL)
    count = len(force)
    rows = {
        "step": np.array(["3 pull"] * count),
        "rope strain (-)": 0.001 * np.arange(count),
        "force (kN)": np.array(force),
        "max penetration / radius (-)": np.full(count, 0.01),
        "stabilisation residual share (-)": np.zeros(count),
        "stabilisation work share (-)": 0.01 * np.arange(count),
    }
    results = final_results(scene, build_rope(scene), rows)
    assert ("rope_axial_stiffness" in results) == has_stiffness == ("efficiency" in results)
    assert results["max_penetration_over_radius"] == 0.01
    assert results["stabilisation_residual_share"] == 0.0
    assert results["stabilisation_work_share"] == 0.01 * (count - 1)  # of all increments
