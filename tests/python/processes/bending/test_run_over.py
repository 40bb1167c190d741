"""A rope that is pulled, bent, drawn over the sheave, straightened and pulled on."""

from pathlib import Path

import numpy as np
import pytest

SCENE = Path(__file__).parent / "small_bend.toml"
WAY, DIAMETER = 0.5, 30.0  # mm
STEPS = f"""
[[steps]]
kind = "form"
tension = 10.0
[[steps]]
kind = "pull"
to_force = 0.1
strain_increment = 0.0005
[[steps]]
kind = "bend"
travel = 2.0
increments = 2
[[steps]]
kind = "run_over"
way = {WAY}
increments = 1
[[steps]]
kind = "straighten"
increments = 2
[[steps]]
kind = "pull"
to_force = 0.15
strain_increment = 0.0005
"""


@pytest.fixture(scope="module")
def drawn(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("drawn")
    scene = folder / "drawn.toml"
    scene.write_text(SCENE.read_text().split("[[steps]]")[0] + STEPS)
    return run(folder / "out", "--set", "sheave.motion=free", scene=scene)


def test_every_step_goes_on_from_the_one_before(drawn):
    assert drawn.code == 0, drawn.stderr
    steps = [step.split()[1] for step in drawn.history["step"]]
    assert list(dict.fromkeys(steps)) == ["form", "pull", "bend", "run_over", "straighten"]
    assert steps[-1] == "pull"
    pulled = np.array(steps) == "pull"
    force, strain = (drawn.history[name][pulled] for name in ("force (kN)", "rope strain (-)"))
    assert force[-1] == pytest.approx(0.15)
    assert strain[-1] > strain[0]


def test_the_rope_goes_to_either_side_and_back_and_rubs(drawn):
    drawn_over = np.array([step.endswith("run_over") for step in drawn.history["step"]])
    way = drawn.history["run (mm)"][drawn_over]
    assert {WAY, -WAY} <= set(way.round(9)) and way[-1] == pytest.approx(0.0, abs=1e-9)
    work = drawn.history["friction work (mJ)"]
    assert np.all(np.diff(work) >= 0.0) and work[drawn_over][-1] > work[drawn_over][0]
    assert drawn.values["friction_work_per_cycle"] > 0.0
