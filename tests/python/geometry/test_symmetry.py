"""Rotations that bring a rope back to itself: images of lines, and invariance of the motif as oracle."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from braidx.geometry import build_rope, rotations
from braidx.scene import load_scene

DEMOS = Path(__file__).parents[3] / "demos"


@pytest.mark.parametrize(
    ("name", "fold"), [("tensile_test", 3), ("small_rope", 4), ("braid_16x3", 4)]
)
def test_yarns_are_images_of_their_leaders(name, fold):
    rope = build_rope(load_scene(DEMOS / f"{name}.toml", ["rope.pitches=1"]))
    found = rotations(rope)
    assert found.fold == fold
    assert np.array_equal(np.bincount(found.turns), np.full(fold, rope.num_yarns // fold))
    for yarn, line in enumerate(rope.centre_lines):
        angle = 2 * np.pi * found.turns[yarn] / fold
        c, s = np.cos(angle), np.sin(angle)
        leader = rope.centre_lines[found.leader[yarn]]
        turned = leader @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        assert np.allclose(turned, line, atol=1e-9)


@settings(max_examples=20)
@given(st.lists(st.sampled_from([-1, 1]), min_size=16, max_size=16))
def test_the_fold_is_that_of_the_motif(entries):
    """Turning by n of 4 strands shifts rows and columns of the motif by n."""
    motif = np.array(entries).reshape(4, 4)
    scene = load_scene(DEMOS / "small_rope.toml", [f"braid.motif={motif.tolist()}"])
    same = [f for f in (4, 2) if np.array_equal(np.roll(motif, (4 // f, 4 // f), (0, 1)), motif)]
    assert rotations(build_rope(scene)).fold == max(same, default=1)
