"""The pitch of a rope comes from the angle of its braid, from itself, or from both if they agree."""

import math
from dataclasses import replace

import pytest

from braidx.scene import BraidRecipe, RopeRecipe, Scene, SceneError, YarnModel, load_scene, to_toml

PITCH = 2.0 * math.pi * 4.0 * math.tan(math.radians(60.0))  # 43.53 mm


def scene(pitch=None, **braid):
    return Scene(
        rope=RopeRecipe(pitch=pitch),
        braid=BraidRecipe(helix_radius=4.0, **braid),
        yarn=YarnModel(radius=0.5),
    )


@pytest.mark.parametrize("angle", [{"angle": 60.0}, {"angle_from_axis": 30.0}])
def test_an_angle_gives_the_pitch(angle):
    assert scene(**angle).rope.pitch == pytest.approx(PITCH, rel=1e-14)
    assert scene(**angle).length == pytest.approx(2.0 * PITCH)
    assert scene(PITCH * (1.0 + 9e-10), **angle).rope.pitch == PITCH * (1.0 + 9e-10)


@pytest.mark.parametrize("angle", [{"angle": 61.3}, {"angle_from_axis": 27.1}, {}])
def test_pitch_and_angle_survive_writing_and_reading(angle, tmp_path):
    written = scene(**angle) if angle else scene(43.0)
    copy = tmp_path / "scene.toml"
    copy.write_text(to_toml(written), "utf-8")
    assert load_scene(copy) == replace(written, rope=replace(written.rope, name="scene"))
    assert replace(written, rope=replace(written.rope, pitches=1)).rope.pitch == written.rope.pitch


@pytest.mark.parametrize(
    ("arguments", "wanted"),
    [
        ({}, "rope.pitch: missing, add it, in mm, or give braid.angle, in degrees."),
        (
            {"pitch": 43.5, "angle": 60.0},
            "rope.pitch = 43.5: braid.angle = 60 degrees gives 43.53118474 mm; leave one",
        ),
        (
            {"pitch": PITCH * (1.0 + 2e-9), "angle_from_axis": 30.0},
            "braid.angle_from_axis = 30 degrees gives 43.53118474 mm",
        ),
        (
            {"angle": 60.0, "angle_from_axis": 30.0},
            "braid.angle_from_axis = 30.0: braid.angle = 60 says it already; leave one",
        ),
        ({"angle": 90.0}, "braid.angle = 90.0: out of range"),
        ({"angle_from_axis": 0.0}, "braid.angle_from_axis = 0.0: out of range"),
        ({"angle": 60.0, "undulation": 4.0}, "braid.undulation = 4.0: must be below"),
    ],
)
def test_what_says_too_little_or_too_much_is_refused(arguments, wanted):
    with pytest.raises(SceneError) as caught:
        scene(**arguments)
    assert wanted in str(caught.value)
