"""The start configuration: nodes uniform in z, helices, periodic ends, lay."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from braidx.geometry import build_rope
from braidx.geometry.helix import StrandHelix, place_yarn
from braidx.geometry.strand import touching_radius
from braidx.scene import RopeRecipe, Scene, StrandRecipe, YarnModel, load_scene

PAPER = Path(__file__).parents[3] / "demos" / "tensile_test.toml"


@pytest.mark.parametrize("degree", [1, 2])
def test_the_rope_of_paper_1(degree):
    rope = build_rope(load_scene(PAPER, [f"yarn.degree={degree}"]))
    assert (rope.num_yarns, rope.num_strands, len(rope.crossings)) == (84, 12, 144)
    assert rope.layer.tolist() == [0] * 6 + [1] * 6
    assert np.bincount(rope.strand).tolist() == [7] * 12
    for line in rope.centre_lines + rope.strand_lines:
        assert line.shape == (80 * degree + 1, 3)
        assert np.allclose(line[:, 2], np.linspace(0.0, 264.0, 80 * degree + 1), atol=1e-12)
        assert np.allclose(line[0, :2], line[-1, :2], atol=1e-11)
    for yarn, line in enumerate(rope.centre_lines):
        if yarn % 7 == 0:
            assert np.allclose(line, rope.strand_lines[yarn // 7])


@settings(max_examples=30)
@given(st.floats(0.0, 20.0), st.sampled_from([-1, 1]), st.floats(0.1, 2.0), st.integers(-5, 5))
def test_a_yarn_keeps_its_distance_from_the_strand(radius, sense, distance, turns):
    helix = StrandHelix(radius, 132.0, sense, 0.3)
    z = np.linspace(0.0, 132.0, 30)
    line = place_yarn(helix, distance, 0.7, 2.0 * np.pi * turns / 132.0, z)
    fine = helix.point(np.linspace(-40.0, 172.0, 40001))
    nearest = [np.linalg.norm(fine - node, axis=1).min() for node in line]
    assert np.allclose(nearest, distance, atol=1e-3)


@pytest.mark.parametrize(("lay", "sense"), [("Z", 1), ("S", -1), ("same", 1), ("opposite", -1)])
def test_the_lay_of_a_straight_strand(lay, sense):
    scene = Scene(
        rope=RopeRecipe(pitch=60.0, pitches=1, type="strand"),
        yarn=YarnModel(radius=0.5),
        strand=StrandRecipe(rings=(1, 6), yarn_pitch=20.0, lay=lay),
    )
    rope = build_rope(scene)
    line, nodes_in_a_turn = (
        rope.centre_lines[1],
        scene.yarn.elements_per_pitch * scene.yarn.degree / 3,
    )
    turn = np.unwrap(np.arctan2(line[:, 1], line[:, 0]))
    assert turn[-1] - turn[0] == pytest.approx(sense * 3 * 2.0 * np.pi)
    assert turn[1] - turn[0] == pytest.approx(sense * 2.0 * np.pi / nodes_in_a_turn)
    c = 1.0 - np.cos(
        2.0 * np.pi / nodes_in_a_turn
    )  # see test_touching_yarns.py for the rest of the radius
    outside = 1.0 / np.sqrt(1.0 - c**2 / 4.0)
    radius = touching_radius(6, 0.5, True, 20.0) * outside
    assert np.allclose(np.hypot(line[:, 0], line[:, 1]), radius, rtol=1e-12)
    assert len(rope.crossings) == 0


def test_untwisted_yarns_of_a_strand_are_straight_rods():
    scene = Scene(
        rope=RopeRecipe(pitch=60.0, pitches=1, type="strand"),
        yarn=YarnModel(radius=0.5),
        strand=StrandRecipe(rings=(3,)),
    )
    for line in build_rope(scene).centre_lines:
        assert np.allclose(line[:, :2], line[0, :2])


def test_yarns_of_opposite_lay_lie_almost_along_the_axis_outside():
    rope = build_rope(load_scene(PAPER, ['strand.yarn_pitch="pitch/4"', "braid.helix_radius=6.6"]))
    for yarn in (1, 43):
        line = rope.centre_lines[yarn]
        outside = 5 + np.argmax(np.hypot(line[5:40, 0], line[5:40, 1]))
        step = line[outside + 1] - line[outside - 1]
        assert step[2] / np.linalg.norm(step) > 0.995
