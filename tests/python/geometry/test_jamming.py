"""Braids of single yarns jam where the closed form says, and what the error names is free of it."""

import math
import re
from dataclasses import replace

import pytest

from braidx.geometry import check_geometry
from braidx.geometry.closed_forms import jamming_angle
from braidx.scene import BraidRecipe, RopeRecipe, Scene, SceneError, YarnModel


def scene(pitch=None, radius=1.0, **braid):
    """Twelve yarns of width 2 mm on a radius of 4 mm: they jam at 61.48 degrees from the axis."""
    recipe = {"helix_radius": 4.0, "motif": "1-over-1-under", **braid}
    return Scene(
        rope=RopeRecipe(pitch=pitch), braid=BraidRecipe(**recipe), yarn=YarnModel(radius=radius)
    )


def refused(jammed):
    with pytest.raises(SceneError) as caught:
        check_geometry(jammed)
    return str(caught.value)


def test_yarns_jam_at_the_angle_of_the_closed_form():
    jamming = jamming_angle(12, 2.0, 4.0)
    assert jamming is not None and math.degrees(jamming) == pytest.approx(61.48, abs=5e-3)
    check_geometry(scene(angle_from_axis=61.47))
    check_geometry(scene(angle_from_axis=math.degrees(jamming)))
    message = refused(scene(angle_from_axis=61.49))
    assert "yarn.radius = 1.0: 6 strands of diameter 2 mm per direction jam" in message
    assert "braid.helix_radius = 4 mm leaves each 1.999 mm" in message


@pytest.mark.parametrize("given", [{"angle_from_axis": 70.0}, {"angle": 20.0}, {"pitch": 13.0}])
def test_every_cure_is_one(given):
    """Within the digits that are printed; a little beyond them the braid jams again."""
    message = refused(scene(**given))
    radius, helix, degrees, pitch = (
        float(re.search(pattern, message)[1])  # type: ignore[index]
        for pattern in (
            r"use at most ([\d.]+) mm",
            r"helix_radius at least ([\d.]+) mm",
            r"at most ([\d.]+) degrees from the axis",
            r"rope.pitch = ([\d.]+) mm",
        )
    )
    check_geometry(scene(radius=0.999 * radius, **given))
    refused(scene(radius=1.001 * radius, **given))
    check_geometry(scene(helix_radius=helix, **given))
    refused(scene(helix_radius=0.999 * helix, **given))
    check_geometry(scene(angle_from_axis=degrees))
    refused(scene(angle_from_axis=1.001 * degrees))
    check_geometry(scene(pitch=1.001 * pitch))


def test_no_angle_helps_yarns_that_are_too_thick():
    assert "degrees" not in refused(scene(radius=2.1, pitch=40.0))
    assert "at least" not in refused(scene(radius=2.1, pitch=25.0))


def test_one_strand_per_direction_has_no_neighbours():
    alone = scene(pitch=6.0, strands_per_direction=(1, 1))
    check_geometry(replace(alone, yarn=YarnModel(radius=2.0)))
