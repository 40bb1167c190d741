"""Recipes that cannot be placed are refused, with the cure."""

from pathlib import Path

import pytest

from braidx.geometry import build_rope, check_geometry
from braidx.scene import SceneError, load_scene

DEMOS = Path(__file__).parents[3] / "demos"


@pytest.mark.parametrize("path", sorted(DEMOS.glob("*.toml")), ids=lambda path: path.stem)
def test_demos_can_be_placed(path):
    check_geometry(load_scene(path))


@pytest.mark.parametrize("override", ["rope.pitch=121", "rope.pitch=153", "strand.yarn_pitch=44"])
def test_variants_of_the_paper_can_be_placed(override):
    check_geometry(load_scene(DEMOS / "tensile_test.toml", [override]))


@pytest.mark.parametrize(
    ("override", "wanted"),
    [
        ("strand.yarn_pitch=50", ["strand.yarn_pitch = 50.0", "132 mm", '44 mm ("pitch/3")']),
        ("strand.yarn_pitch=200", ["strand.yarn_pitch", '132 mm ("pitch/1")']),
        ("strand.yarn_pitch=pitch/90", ["turn back", "at least"]),
        ("yarn.radius=1.2", ["yarn.radius = 1.2", "1 + 6", "at most 0.9 mm"]),
        ("braid.helix_radius=4", ["6 strands", "jam", "4.115 mm", "at most 0.666 mm"]),
        ("braid.strands_per_direction=[5, 5]", ["braid.motif", "4 x 4", "5 + 5", "[6, 6]"]),
        ("braid.motif=[[1, -1, 1, -1, 1]]", ["1 x 5", "6 + 6", "[5, 5]"]),
    ],
)
def test_what_cannot_be_placed_is_named_with_its_cure(override, wanted):
    with pytest.raises(SceneError) as caught:
        build_rope(load_scene(DEMOS / "tensile_test.toml", [override]))
    for text in wanted:
        assert text in str(caught.value)


@pytest.mark.parametrize(
    ("options", "key"),
    [
        (["braid.helix_radius=4"], "yarn.radius"),
        (["yarn.radius=1.2"], "yarn.radius"),
        (["strand.helix_radius=touching", "yarn.radius=1.4"], "yarn.radius"),
    ],
)
def test_the_largest_radius_named_is_admissible(options, key):
    path = DEMOS / "tensile_test.toml"
    with pytest.raises(SceneError) as caught:
        build_rope(load_scene(path, options))
    largest = float(str(caught.value).partition("at most ")[2].split()[0])
    build_rope(load_scene(path, [*options, f"yarn.radius={largest * 0.999}"]))
    with pytest.raises(SceneError):
        build_rope(load_scene(path, [*options, f"yarn.radius={largest * 1.001}"]))
