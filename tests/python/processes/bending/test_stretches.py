"""Which stretch of a yarn is what."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from braidx.geometry import build_rope
from braidx.processes.bending.cheapest import foreseen_bending_share
from braidx.processes.bending.stretches import (
    Stretch,
    as_table,
    from_table,
    stretches_of,
    with_solid,
)
from braidx.scene import load_scene

SCENE = Path(__file__).parent / "small_bend.toml"


@pytest.mark.parametrize("model", ["cable", "beam", "solid"])
def test_yarns_of_one_model_are_one_stretch(model):
    scene = load_scene(SCENE, [f"yarn.model={model}"])
    lines = build_rope(scene).centre_lines
    stretches = stretches_of(scene, lines)
    assert [s.yarn for s in stretches] == list(range(6))
    assert all(s.model == model and s.nodes == slice(0, len(lines[0])) for s in stretches)


def test_mixed_yarns_are_solid_about_the_crown_and_covered_from_end_to_end():
    scene = load_scene(
        SCENE, ["yarn.model=mixed", "yarn.outer_model=cable", "yarn.solid_stretch=14"]
    )
    lines = build_rope(scene).centre_lines
    for yarn in range(6):
        mine = [s for s in stretches_of(scene, lines) if s.yarn == yarn]
        assert [s.model for s in mine] == ["cable", "solid", "cable"]
        assert mine[0].first == 0 and mine[-1].last == len(lines[yarn]) - 1
        assert all(a.last == b.first for a, b in zip(mine, mine[1:]))
        z = lines[yarn][[mine[1].first, mine[1].last], 2]
        assert np.all(np.abs(z - scene.crown) <= 7.0)


def test_yarns_may_have_models_of_their_own():
    scene = load_scene(SCENE)
    scene = replace(scene, yarn=replace(scene.yarn, models={"2": "cable"}))
    models = [s.model for s in stretches_of(scene, build_rope(scene).centre_lines)]
    assert models == ["beam", "beam", "cable", "beam", "beam", "beam"]


@pytest.mark.parametrize(
    ("pretension", "bundle_factor", "model"),
    [(0.0, 1e-4, "beam"), (1.0, 1.0, "beam"), (1.0, 1e-4, "cable")],
)
def test_auto_starts_from_cables_where_they_are_pulled_more_than_bent(
    pretension, bundle_factor, model
):
    words = [
        "yarn.model=auto",
        f"steps.bend.pretension={pretension}",
        f"yarn.bundle_factor={bundle_factor}",
    ]
    scene = load_scene(SCENE, words)
    assert {s.model for s in stretches_of(scene, build_rope(scene).centre_lines)} == {model}


def test_share_of_bending_of_a_yarn_bent_like_the_rope():
    """rho = 15 + 4.7, six yarns at 30 degrees; E I = E A r^2 / 4."""
    scene = load_scene(SCENE, ["yarn.model=auto", "steps.bend.pretension=1"])
    tension = 1000.0 / 6 / np.cos(np.pi / 6)
    bending, axial = 50e3 * 0.9**2 / 4 / 19.7**2, tension**2 / 50e3
    assert foreseen_bending_share(scene) == pytest.approx(bending / (bending + axial))


def test_tables_of_stretches_can_be_read_again():
    solid = np.array([False, True, True, True, False, False])
    stretches = tuple(with_solid(3, "beam", solid))
    assert stretches[1] == Stretch(3, "solid", 1, 3)
    assert from_table(as_table(stretches)) == stretches
