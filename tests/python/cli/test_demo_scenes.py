"""Every scene among the demos is one that `check` and `show` accept."""

from pathlib import Path

import pytest

from braidx.scene import load_scene

DEMOS = Path(__file__).parents[3] / "demos"
SCENES = sorted(DEMOS.glob("*.toml"))


def test_there_are_scenes():
    assert {"small_rope", "tensile_test"} <= {path.stem for path in SCENES}


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_check(braidx, path):
    result = braidx("check", str(path))
    assert result.code == 0, result.stderr
    assert path.stem in result.stdout and "yarns" in result.stdout


@pytest.mark.parametrize("model", ["cable", "beam"])
@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_check_with_either_model(braidx, path, model):
    assert braidx("check", str(path), "--set", f"yarn.model={model}").code == 0


@pytest.mark.parametrize("pitch", [121, 153])
def test_check_of_the_pitches_of_the_paper(braidx, pitch):
    assert (
        braidx("check", str(DEMOS / "tensile_test.toml"), "--set", f"rope.pitch={pitch}").code == 0
    )


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_expected_values_name_their_source(path):
    expected = load_scene(path).expected
    assert expected and all(value.source for value in expected.values())
