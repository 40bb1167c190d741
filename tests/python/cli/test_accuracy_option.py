"""--accuracy: chosen options are printed and recorded; wrong ones end with the ones that there are."""

import json
from pathlib import Path

import pytest

from braidx.output.summary import Summary
from braidx.scene import load_scene

ROPE = """
[rope]
pitch = 36.0
[braid]
strands_per_direction = [4, 4]
motif = "1-over-1-under"
helix_radius = 2.0
[yarn]
radius = 0.86
elements_per_pitch = 36
[[steps]]
kind = "pull"
to_force = 5.0
"""


@pytest.fixture
def rope(tmp_path):
    path = tmp_path / "rope.toml"
    path.write_text(ROPE)
    return path


def said(text):
    return " ".join(text.split())


def test_check_tells_what_is_chosen_and_what_is_stated(braidx, rope):
    done = braidx("check", str(rope), "--accuracy", "5%")
    assert done.code == 0, done.stderr
    text = said(done.stdout)
    assert "accuracy 5%: chosen" in text and "contact.penetration_tolerance = " in text
    assert ("states: yarn.elements_per_pitch = 36" in text) or (
        "chosen yarn.degree = 1, yarn.elements_per_pitch = 36" in text
    )


def test_check_says_nothing_of_accuracy_unless_asked(braidx, rope):
    assert "accuracy" not in braidx("check", str(rope)).stdout


@pytest.mark.parametrize("wrong", ["0.01%", "good"])
def test_a_wrong_accuracy_names_those_there_are(braidx, rope, wrong):
    done = braidx("run", str(rope), "--accuracy", wrong)
    assert done.code == 2
    (line,) = done.stderr.splitlines()
    assert "--accuracy" in line and "5%, 1% or 0.1%" in line


def test_the_summary_has_what_was_chosen(tmp_path):
    summary = Summary("rope")
    assert "accuracy" not in summary.as_dict()
    summary.accuracy = {"level": "1%", "chosen": {"yarn.degree": 1}}
    summary.write(tmp_path / "summary.json")
    written = json.loads((tmp_path / "summary.json").read_text())
    assert written["accuracy"] == {"level": "1%", "chosen": {"yarn.degree": 1}}


def test_the_option_is_that_of_the_scene(rope):
    path = Path(rope)
    path.write_text(ROPE + '[solver]\naccuracy = "1%"\n')
    assert load_scene(path) == load_scene(path, ['solver.accuracy="1%"'])
