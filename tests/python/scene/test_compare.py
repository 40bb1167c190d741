"""What makes two scenes different."""

from pathlib import Path

import pytest

from braidx.scene import difference, load_scene

SMALL = Path(__file__).parents[3] / "demos" / "small_rope.toml"


@pytest.mark.parametrize(
    ("override", "wanted"),
    [
        ("contact.friction=0.2", "contact.friction: 0.1 here, 0.2 there"),
        ("steps.pull.to_force=3", "steps.2.to_force: 5.0 here, 3.0 there"),
        ("yarn.area=1", "yarn.area: left out here, 1.0 there"),
        ("output.pictures=false", ""),
        ("expected.efficiency.reference=1", ""),
    ],
)
def test_the_first_difference_is_named(override, wanted):
    assert difference(load_scene(SMALL), load_scene(SMALL, [override])) == wanted
