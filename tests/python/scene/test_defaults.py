"""Defaults that depend on other keys: what is stated stays, what is left out follows, and the scene shows it."""

from __future__ import annotations

import tomllib
from dataclasses import replace

import pytest

from braidx.scene import difference, load_scene, scene_from_dict, to_toml

ROPE = """
[rope]
pitch = 36.0
[braid]
strands_per_direction = [4, 4]
motif = "1-over-1-under"
helix_radius = 2.0
[yarn]
radius = 0.86
"""
BENDING = """
[sheave]
diameter = 30.0
[[steps]]
kind = "form"
[[steps]]
kind = "bend"
travel = 8.0
"""
STRAND = '[rope]\ntype = "strand"\npitch = 66.0\n[yarn]\nradius = 0.86\n'


def scene_of(text, **tables):
    data = tomllib.loads(text)
    for name, entries in tables.items():
        data.setdefault(name, {}).update(entries)
    return scene_from_dict(data, "scene")


def mesh(text, **yarn):
    made = scene_of(text, yarn=yarn).yarn
    return made.degree, made.elements_per_pitch


@pytest.mark.parametrize(
    ("yarn", "expected"),
    [
        ({}, (2, 24)),
        ({"model": "beam"}, (1, 40)),
        ({"models": {"3": "beam"}}, (1, 40)),
        ({"elements_per_pitch": 36}, (1, 36)),
        ({"degree": 1}, (1, 40)),
        ({"degree": 2}, (2, 24)),
        ({"degree": 2, "model": "beam"}, (2, 24)),
        ({"degree": 2, "elements_per_pitch": 9}, (2, 9)),
    ],
)
def test_the_mesh_is_what_the_scene_states_or_else_suits_its_yarns(yarn, expected):
    assert mesh(ROPE, **yarn) == expected


def test_curved_elements_go_by_crossings():
    assert mesh(ROPE.replace("[4, 4]", "[6, 6]").replace("36.0", "72.0")) == (2, 36)
    assert mesh(ROPE.replace("[4, 4]", "[2, 2]")) == (2, 24)
    assert mesh(STRAND) == (2, 24)


def test_bundles_of_yarns_have_straight_elements():
    assert mesh(ROPE + "[strand]\nrings = [3]\n") == (1, 40)
    assert mesh(STRAND + "[strand]\nrings = [1, 6]\n") == (2, 24)


def test_nodes_of_curved_elements_stay_two_thirds_of_a_radius_apart():
    assert mesh(ROPE.replace("0.86", "1.35").replace("[4, 4]", "[6, 6]")) == (2, 20)


@pytest.mark.parametrize(
    ("text", "yarn", "depth"),
    [
        (ROPE, {"elements_per_pitch": 200}, 0.015),
        (ROPE + BENDING, {"elements_per_pitch": 48}, 0.005),
        (ROPE + BENDING, {"elements_per_pitch": 47}, 0.015),
        (ROPE + BENDING, {"elements_per_pitch": 24, "degree": 2}, 0.005),
        (ROPE + BENDING, {}, 0.005),
        (ROPE + BENDING, {"model": "beam"}, 0.015),
    ],
)
def test_bent_ropes_of_fine_elements_are_kept_apart_better(text, yarn, depth):
    assert scene_of(text, yarn=yarn).contact.penetration_tolerance == depth
    given = scene_of(text, yarn=yarn, contact={"penetration_tolerance": 0.03})
    assert given.contact.penetration_tolerance == 0.03


@pytest.mark.parametrize("text", [ROPE, ROPE + BENDING])
def test_a_scene_shows_them_and_is_the_same_again(text, tmp_path):
    scene = scene_of(text)
    path = tmp_path / "scene.toml"
    path.write_text(to_toml(scene))
    assert "elements_per_pitch = 24" in path.read_text()
    assert difference(scene, load_scene(path)) == ""


def test_they_are_worked_out_anew_where_a_scene_is_made_to_state_less():
    scene = scene_of(ROPE, yarn={"elements_per_pitch": 36})
    again = replace(scene, yarn=replace(scene.yarn, degree=None, elements_per_pitch=None))
    assert (again.yarn.degree, again.yarn.elements_per_pitch) == (2, 24)
