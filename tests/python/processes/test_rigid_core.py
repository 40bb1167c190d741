"""A rigid core stays where it is while the braid about it is pulled."""

import numpy as np
import pytest

from braidx.output import snapshot
from braidx.output.contact_table import YARN_CORE
from runs import SMALL

CORE = 1.0  # mm
YARN = 0.86


@pytest.fixture(scope="module")
def pulled(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("core")
    scene = folder / "core.toml"
    core = f'[core]\nmodel = "rigid"\nradius = {CORE}\n'
    scene.write_text(SMALL.read_text("utf-8") + core, "utf-8")
    done = run(folder / "out", scene=scene)
    assert done.code == 0, done.stderr
    (last,) = (done.folder / "snapshots").glob("*_5_kN.npz")
    return snapshot.load(last)


def test_yarns_stay_outside_of_the_core(pulled):
    nearest = min(np.hypot(line[:, 0], line[:, 1]).min() for line in pulled.centre_lines)
    assert nearest == pytest.approx(CORE + YARN, rel=0.02)


def test_the_core_holds_what_yarns_pull_inwards(pulled):
    """In the mean along the rope: sum of T (dx^2 + dy^2) / dl = sum of contact forces times the distances across the
    axis that they act over, from each other for two yarns and from the axis for a yarn on the core (virial theorem).
    """
    table = pulled.contacts
    on_core = table.kind == YARN_CORE
    force = table.normal_force[:, None] * table.normal + table.friction_force
    across = (force * table.normal)[:, :2].sum(axis=1)
    push = across @ (table.gap + YARN + np.where(on_core, CORE, YARN))
    pull = 0.0
    for line, tension in zip(pulled.centre_lines, pulled.tension, strict=True):
        step = np.diff(line, axis=0)
        pull += tension @ ((step[:, 0] ** 2 + step[:, 1] ** 2) / np.linalg.norm(step, axis=1))
    assert push == pytest.approx(pull, rel=0.01)
    assert 0.1 < table.normal_force[on_core].sum() / table.normal_force.sum()
    assert not table.friction_force[on_core].any()
