"""The benchmarks at their smallest, so that they never rot. No time is judged here."""

import numpy as np
import pytest
from crossing_yarns import FRICTION, run
from newton_step import load_model, step_costs
from scaling import exponent, measure, run_series, scene_of, table

from braidx.scene import Pull


def test_exponent():
    sizes = np.array([12, 36, 84])
    assert exponent(sizes, 0.01 * sizes**1.5) == pytest.approx(1.5)
    assert np.isnan(exponent([12], [1.0]))


@pytest.mark.parametrize("num_yarns", [12, 36, 84])
def test_scenes_pull_all_yarns_to_one_stress(num_yarns):
    scene = scene_of(num_yarns, 1)
    (force,) = [step.to_force for step in scene.steps if isinstance(step, Pull)]
    assert force / num_yarns == pytest.approx(70 / 84)


def test_table():
    row = {"form": 1.0, "settle": 2.0, "pull": 3.0, "all": 6.0, "memory": 200.0}
    text = table("yarns", {12: row, 24: {name: 2 * value for name, value in row.items()}})
    assert text.splitlines()[-1] == "| exponent | 1.00 | 1.00 | 1.00 | 1.00 | |"


def test_smallest_series(tmp_path):
    coarse = ["yarn.elements_per_pitch=36"]
    tables = run_series(tmp_path, yarns=[12], pitches=[1], overrides=coarse)
    print("\n\n".join(tables))
    folder = tmp_path / "12_yarns_1_pitches"
    assert measure(scene_of(12, 1), folder)["all"] > 0  # not repeated
    costs = step_costs(*load_model(folder), repeats=1)
    assert all(seconds >= 0 for seconds in costs.values())
    assert {"contact update", "linear solve"} <= set(costs)


def test_smallest_crossing():
    """Slid far enough that friction is spent; the slope of facets adds to it or takes from it, by 12 % at most."""
    outcome = run(8, press=0.3, slide=0.05, increments=(2, 2))
    assert outcome.pressed > 5.0 and outcome.normal == pytest.approx(outcome.pressed, rel=0.05)
    assert outcome.tangential == pytest.approx(FRICTION * outcome.normal, rel=0.12)
    assert outcome.iterations >= outcome.updates > 0
