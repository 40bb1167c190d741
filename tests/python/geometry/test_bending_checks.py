"""Core, groove and yarn numbers that do not suit the rope are refused, with the cure."""

from pathlib import Path

import pytest

from braidx.geometry import build_rope, one_pitch, outer_diameter
from braidx.geometry.bending_checks import inner_radius
from braidx.scene import SceneError, load_scene

DEMOS = Path(__file__).parents[3] / "demos"
BENT = DEMOS / "bending_over_sheave.toml"


def test_diameters_of_the_rope_of_paper_2():
    scene = load_scene(BENT)
    assert outer_diameter(scene) == pytest.approx(12.0)
    assert inner_radius(scene) == pytest.approx(2.0)
    assert build_rope(scene).crown == scene.crown == scene.length / 2.0
    strand = load_scene(DEMOS / "twisted_strand.toml")
    assert outer_diameter(strand) == pytest.approx(2.0 * (1.7376785 + 0.86))  # touching


def test_a_rope_that_is_bent_is_formed_one_pitch_long_and_bent_whole():
    """One pitch is shorter than the ends travel, and still can be placed."""
    scene = load_scene(BENT)
    rope, pitch = build_rope(scene), one_pitch(scene)
    assert rope.length == pytest.approx(4.0 * pitch.length)
    assert len(rope.crossings) == 4 * len(pitch.crossings)
    for whole, part in zip(rope.centre_lines, pitch.centre_lines, strict=True):
        assert whole[: len(part)] == pytest.approx(part, abs=1e-9)


@pytest.mark.parametrize(
    "override", ["core.radius=2.099", "sheave.groove_radius=6.0", "yarn.models.11=cable"]
)
def test_what_just_fits_is_placed(override):
    extra = ["sheave.groove=round"] if "groove" in override else []
    build_rope(load_scene(BENT, [override, *extra]))


@pytest.mark.parametrize(
    ("overrides", "wanted"),
    [
        (["core.radius=2.101"], "core.radius = 2.101: too thick, the yarns leave 2 mm"),
        (["core.radius=2.101"], "use at most 2.1 mm, or a larger braid.helix_radius"),
        (["braid.helix_radius=4.5", "core.radius=2.7"], "use at most 2.6 mm"),
        (["yarn.radius=1.05", "core.radius=2.1"], "use at most 2.055 mm"),
        (["braid.undulation=3.2"], "no core fits in there"),
        (
            ["sheave.groove=round", "sheave.groove_radius=5.9"],
            "sheave.groove_radius = 5.9: narrower than the rope; use at least its radius, 6 mm.",
        ),
        (
            ["yarn.models.12=cable"],
            'yarn.models.12 = "cable": no such yarn; use numbers from 0 to 11.',
        ),
    ],
)
def test_what_does_not_fit_is_refused(overrides, wanted):
    with pytest.raises(SceneError) as caught:
        build_rope(load_scene(BENT, overrides))
    assert wanted in str(caught.value)


def test_solid_yarns_that_are_placed_and_not_formed_do_not_fold(tmp_path):
    text = BENT.read_text("utf-8")
    form, bend = text.index('kind = "form"'), text.index('[[steps]]\nkind = "bend"')
    path = tmp_path / "placed.toml"
    path.write_text(text[: text.rindex("[[steps]]", 0, form)] + text[bend:], "utf-8")
    options = ["braid.angle=45", "rope.pitches=7", "yarn.model=solid"]
    build_rope(load_scene(BENT, options))
    build_rope(load_scene(path, ["yarn.model=solid"]))
    build_rope(load_scene(path, [*options, "yarn.model=beam"]))
    build_rope(load_scene(path, [*options, "braid.undulation=0.7"]))
    with pytest.raises(SceneError) as caught:
        build_rope(load_scene(path, options))
    assert "braid.undulation = 1.0: bends strands to a radius of 0.758 mm" in str(caught.value)
