"""The small rope pulled and released: without friction it gives back what it took.

Penalties go with the force, up and down: with those that only rise it gave back a fifth more, and was shorter.
"""

from pathlib import Path

import numpy as np
import pytest

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"
CYCLE = 'kind = "cycle"\nforce_max = 4.0\nforce_min = 1.0\n'


def test_a_rope_without_friction_comes_back(run, tmp_path):
    scene = tmp_path / "cycle.toml"
    text = SMALL.read_text("utf-8").replace('kind = "settle"\n', 'kind = "settle"\nforce = 1.0\n')
    cycled = text.replace('kind = "pull"\nto_force = 5.0\n', CYCLE)
    assert cycled.count("force") > text.count("force")
    scene.write_text(cycled, "utf-8")
    done = run(tmp_path / "run", "--set", "contact.friction=0", scene=scene)
    assert done.code == 0, done.stderr
    rows = done.history
    kept = np.flatnonzero(np.char.endswith(rows["step"], "settle"))[-1]
    strain, force = rows["rope strain (-)"][kept:], rows["force (kN)"][kept:]
    top = int(np.argmax(force))
    assert force[[0, top, -1]] == pytest.approx([1.0, 4.0, 1.0], rel=0.05)
    pulled = np.trapezoid(force[: top + 1], strain[: top + 1])
    released = -np.trapezoid(force[top:], strain[top:])
    slack = abs(force[-1] - force[0]) / (force[top] - force[0])  # what coming to rest is missed by
    assert released == pytest.approx(pulled, rel=0.02 + 2.0 * slack)
    assert abs(strain[-1] - strain[0]) < (0.02 + slack) * np.ptp(strain)
