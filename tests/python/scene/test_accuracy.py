"""Options for an accuracy that is asked for: what is stated stays, what is left open is chosen and told."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from braidx.scene import (
    SceneError,
    difference,
    followed,
    level_of,
    load_scene,
    scene_from_dict,
    to_toml,
)
from braidx.scene.accuracy import BENT, LEVELS, PULLED, fraction, options

DEMOS = Path(__file__).parents[3] / "demos"
ROPE = """
[rope]
pitch = 36.0
[braid]
strands_per_direction = [4, 4]
motif = "1-over-1-under"
helix_radius = 2.0
[yarn]
radius = 0.86
[[steps]]
kind = "form"
[[steps]]
kind = "pull"
to_force = 5.0
"""
BENDING = """
[sheave]
diameter = 30.0
[core]
radius = 0.2
model = "beam"
[[steps]]
kind = "form"
[[steps]]
kind = "bend"
travel = 8.0
[[steps]]
kind = "straighten"
"""


def scene_of(text, level="1%", **tables):
    data = tomllib.loads(text)
    for name, entries in tables.items():
        data.setdefault(name, {}).update(entries)
    data["solver"] = {"accuracy": level}
    return scene_from_dict(data, "rope")


@pytest.mark.parametrize(
    ("text", "level"),
    [("5%", "5%"), ("10 %", "5%"), ("4.9%", "1%"), ("1%", "1%"), (".5%", "0.1%"), ("0.1%", "0.1%")],
)
def test_an_accuracy_is_rounded_to_the_next_that_is_as_good(text, level):
    assert level_of(text) == level


@pytest.mark.parametrize("text", ["0.05%", "0%", "-1%", "1", "fine", ""])
def test_other_accuracies_are_refused_with_the_levels(text):
    with pytest.raises(SceneError, match="5%, 1% or 0.1%") as caught:
        level_of(text)
    assert caught.value.key == "--accuracy"


@pytest.mark.parametrize("level", LEVELS)
def test_what_a_scene_leaves_open_is_chosen(level):
    scene, row = scene_of(ROPE, level), PULLED[level]
    assert scene.yarn.elements_per_pitch == 8 * row.elements
    assert scene.yarn.degree == row.degree
    assert scene.contact.station_spacing == row.station_spacing
    assert scene.contact.penetration_tolerance == row.penetration
    assert scene.steps[1].strain_increment == row.step
    kept = followed(scene)
    assert kept.level == level and kept.stated == {} and len(kept.chosen) == 5


def test_what_a_scene_states_stays():
    text = ROPE.replace("to_force = 5.0", "to_force = 5.0\nstrain_increment = 0.004")
    scene = scene_of(text, yarn={"elements_per_pitch": 99}, contact={"station_spacing": 0.7})
    assert scene.yarn.elements_per_pitch == 99
    assert scene.contact.station_spacing == 0.7
    assert scene.steps[1].strain_increment == 0.004
    kept = followed(scene)
    stated = {
        "yarn.degree": 1,
        "yarn.elements_per_pitch": 99,
        "contact.station_spacing": 0.7,
        "steps.1.strain_increment": 0.004,
    }
    assert kept.stated == stated
    assert kept.chosen.keys() == {"contact.penetration_tolerance"}


def test_coarse_elements_keep_the_penetration_that_they_can_be_kept_apart_to():
    """Of the demo of bending, 3 elements from crossing to crossing do not form with less."""
    scene = load_scene(DEMOS / "bending_over_sheave.toml", ["solver.accuracy=1%"])
    assert scene.yarn.elements_per_pitch == 36 < 12 * BENT["1%"].elements
    assert scene.contact.penetration_tolerance == 0.015 > BENT["1%"].penetration
    assert "contact.penetration_tolerance" not in followed(scene).chosen
    finer = ["solver.accuracy=1%", "yarn.elements_per_pitch=120"]
    scene = load_scene(DEMOS / "bending_over_sheave.toml", finer)
    assert scene.contact.penetration_tolerance == BENT["1%"].penetration


def test_what_is_set_on_the_command_line_stays():
    given = ["solver.accuracy=0.1%", "contact.penetration_tolerance=0.04"]
    scene = load_scene(DEMOS / "small_rope.toml", given)
    assert scene.contact.penetration_tolerance == 0.04
    assert scene.yarn.elements_per_pitch == 36  # of the file
    assert scene.contact.station_spacing == PULLED["0.1%"].station_spacing


def test_bent_ropes_have_a_row_of_their_own():
    text = ROPE.replace('[[steps]]\nkind = "pull"\nto_force = 5.0\n', "")
    text = text.replace('[[steps]]\nkind = "form"\n', "") + BENDING
    scene, row = scene_of(text, yarn={"model": "beam"}), BENT["1%"]
    assert scene.contact.penetration_tolerance == row.penetration
    for step in scene.steps[1:]:
        assert 8.0 / step.increments / 0.86 <= row.step * (1 + 1e-9)


def test_nodes_stay_a_third_of_a_radius_apart():
    """Fewer elements than the table has cannot be kept apart as well: the penetration stays the default."""
    thick = ROPE.replace("radius = 0.86", "radius = 3.0").replace("= 2.0", "= 9.0")
    scene = scene_of(thick, "0.1%")
    assert scene.yarn.elements_per_pitch == 36 < 8 * PULLED["0.1%"].elements
    assert "contact.penetration_tolerance" not in followed(scene).chosen


def test_a_strand_is_divided_by_its_lay():
    strand = '[rope]\ntype = "strand"\npitch = 66.0\n[yarn]\nradius = 0.86\n'
    wanted = options(scene_of(strand, "5%"), "5%")["yarn.elements_per_pitch"]
    assert wanted == pytest.approx(8 * PULLED["5%"].elements, abs=1)


def test_bundles_of_yarns_have_as_many_nodes_of_degree_1():
    scene, row = scene_of(ROPE + "[strand]\nrings = [3]\n", "1%"), PULLED["1%"]
    assert row.degree == 2 and scene.yarn.degree == 1
    assert scene.yarn.elements_per_pitch == 2 * 8 * row.elements
    assert followed(scene).stated == {}


@pytest.mark.parametrize("level", ["", *LEVELS])
def test_a_scene_written_out_is_the_same_again(level, tmp_path):
    scene = scene_of(ROPE, level)
    path = tmp_path / "rope.toml"
    path.write_text(to_toml(scene))
    assert difference(scene, load_scene(path)) == ""
    assert followed(load_scene(path)) == followed(scene)
    assert (followed(scene) is None) == (not level)


def test_without_an_accuracy_defaults_hold():
    scene = scene_of(ROPE, "")
    assert scene == scene_from_dict(tomllib.loads(ROPE), "rope")
    assert scene.yarn.elements_per_pitch == 24 and scene.steps[1].strain_increment == 0.001


@pytest.mark.parametrize("table", [PULLED, BENT])
def test_rows_get_no_coarser_with_the_level(table):
    rows = [table[level] for level in LEVELS]
    assert [fraction(level) for level in LEVELS] == [0.05, 0.01, 0.001]
    for coarse, fine in zip(rows, rows[1:]):
        assert fine.reached <= coarse.reached
