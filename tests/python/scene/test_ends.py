"""Groups of ends in TOML and Python: what they mean, and what is refused, with its cure."""

import math
import tomllib

import pytest

from braidx.geometry import build_rope
from braidx.geometry.end_groups import group_members
from braidx.scene import EndConditions, EndGroup, SceneError, load_scene, to_toml
from braidx.scene.build import scene_from_dict
from braidx.scene.reference import json_schema

ROPE = """
[rope]
pitch = 36.0
[braid]
strands_per_direction = [4, 4]
motif = "1-over-1-under"
helix_radius = 3.0
[strand]
rings = [3]
[yarn]
radius = 0.4
[[steps]]
kind = "settle"
[[steps]]
kind = "pull"
to_force = 1.0
[ends]
transverse = "fixed"
"""
GROUP = '[[ends.groups]]\nend = "last"\nlevel = "rope"\n'


def scene_of(text):
    return scene_from_dict(tomllib.loads(ROPE + text))


def message(text):
    with pytest.raises(SceneError) as caught:
        build_rope(scene_of(text))
    line = str(caught.value)
    assert "\n" not in line
    return line


def test_a_scene_with_groups_survives_writing_and_reading(tmp_path):
    scene = scene_of(
        GROUP
        + "rigid = true\nrotation = { z = 90 }\ndisplacement = { x = 1, y = 'held' }\n"
        + GROUP.replace("rope", "strand")
        + "which = [2]\nforce = { z = 0.5 }\n"
    )
    assert scene.ends.groups[0].rotation == {"z": 90.0}
    copy = tmp_path / "scene.toml"
    copy.write_text(to_toml(scene), "utf-8")
    assert load_scene(copy).ends == scene.ends
    changed = load_scene(copy, ["ends.groups.0.rigid=false"])
    assert not changed.ends.groups[0].rigid and changed.ends.groups[1] == scene.ends.groups[1]


def test_a_group_in_python_equals_one_in_toml():
    ends = EndConditions(
        transverse="fixed",
        groups=(EndGroup(end="last", level="rope", rigid=True, moment={"z": 500}),),
    )
    assert scene_of(GROUP + "rigid = true\nmoment = { z = 500.0 }").ends == ends


def test_what_is_left_out_is_held_of_a_body_and_free_of_a_mean():
    body = EndGroup(end="last", level="rope", rigid=True, force={"x": 1.0}, rotation={"z": "free"})
    assert body.constrained == (False, True, True, True, True, False)
    assert body.loads == (1e3, 0.0, 0.0, 0.0, 0.0, 0.0) and body.releases == (True, True, True)
    mean = EndGroup(end="last", level="rope", rotation={"z": 90}, displacement={"x": 2})
    assert mean.constrained == (True, False, False, False, False, True)
    assert mean.motion == (2.0, 0.0, 0.0, 0.0, 0.0, pytest.approx(math.pi / 2))
    assert mean.releases == (True, True, False)
    assert EndGroup(end="last", level="rope", moment={"x": 1.0}).releases == (False, False, True)


@pytest.mark.parametrize(
    ("level", "count", "size"),
    [("yarn", 24, 1), ("strand", 8, 3), ("layer", 2, 12), ("rope", 1, 24)],
)
def test_groups_of_a_level_share_out_the_yarns(level, count, size):
    rope = build_rope(scene_of(""))
    group = EndGroup(end="last", level=level, rigid=True)
    members = group_members(rope, group)
    assert [len(yarns) for yarns in members] == [size] * count
    assert sorted(sum((list(yarns) for yarns in members), [])) == list(range(24))
    chosen = EndGroup(end="last", level=level, which=[count - 1], rigid=True)
    assert list(group_members(rope, chosen)[0]) == list(members[-1])


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("rotation = { w = 3 }", "ends.groups[0].rotation.w: unknown key; known: x, y, z."),
        ("rotatoin = 3", "ends.groups[0].rotatoin: unknown key; did you mean 'rotation'?"),
        ('rotation = { z = "hold" }', 'z = "hold": not understood, write it as "free", "held" or'),
        ("rotation = 3", "ends.groups[0].rotation = 3: wrong type, give a table of x, y, z"),
        ("which = [1]\nrigid = true", "which = [1]: give numbers from 0 to 0"),
        ("", "ends.groups[0]: says nothing; give displacement, rotation"),
        ("moment = { z = 1 }\nrotation = { z = 2 }", "moment.z = 1.0: does no work, rotation.z is"),
        ("rigid = true\nforce = { z = 1 }", "a step settle moves the last end along the axis"),
    ],
)
def test_a_group_that_makes_no_sense_is_refused(text, wanted):
    assert wanted in message(GROUP + text)


@pytest.mark.parametrize("key", ["rotation", "moment"])
def test_one_end_has_no_rotation(key):
    line = message(GROUP.replace("rope", "yarn") + f"{key} = {{ z = 5 }}")
    assert f"ends.groups[0].{key}.z = 5.0: 1 end of a yarn cannot turn about z" in line


def test_two_bodies_at_one_end_are_refused():
    both = GROUP + "rigid = true\n" + GROUP.replace("rope", "strand") + "rigid = true\n"
    assert "ends.groups[1].rigid = true: ends.groups[0] ties the same ends" in message(both)


def test_the_first_end_has_to_be_held_along_the_axis():
    text = GROUP.replace("last", "first") + 'displacement = { z = "free" }'
    assert "ends.groups[0].displacement: nothing holds the rope along its axis" in message(text)


def test_values_need_a_step_to_grow_in():
    text = (ROPE + GROUP + "rigid = true\nrotation = { z = 5 }").replace(
        '"settle"', '"settle"\nends = 0'
    )
    with pytest.raises(SceneError, match="its values grow in steps settle or hold"):
        build_rope(scene_from_dict(tomllib.loads(text)))


@pytest.mark.parametrize("text", ["rigid = true", 'rotation = { z = "held" }', "force = { x = 1 }"])
def test_a_periodic_end_that_a_group_moves_is_refused(text):
    periodic = ROPE.replace('"fixed"', '"periodic"') + GROUP + text
    with pytest.raises(SceneError, match=r'groups\[0\].end = "last": ends.transverse = "periodic"'):
        scene_from_dict(tomllib.loads(periodic))
    scene_from_dict(tomllib.loads(periodic.replace('"last"', '"first"')))
    scene_from_dict(tomllib.loads(periodic.replace(text, 'displacement = { z = "held" }')))


def test_the_schema_knows_groups_and_their_axes():
    group = json_schema()["properties"]["ends"]["properties"]["groups"]["items"]
    assert group["required"] == ["end", "level"]
    rotation = group["properties"]["rotation"]
    assert set(rotation["properties"]) == {"x", "y", "z"} and not rotation["additionalProperties"]
    assert {"type": "number"} in rotation["properties"]["z"]["anyOf"]
    assert group["properties"]["force"]["properties"]["z"] == {"type": "number"}
