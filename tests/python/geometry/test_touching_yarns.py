"""Yarns of a strand that touch: sampled helices are the oracle."""

import math

import numpy as np
import pytest

from braidx.geometry import build_rope
from braidx.geometry.strand import touching_radius
from braidx.scene import RopeRecipe, Scene, SceneError, StrandRecipe, YarnModel


def nearest(radius, count, pitch):
    """Distance of neighbours on helices: from one point of one to a turn of the other, densely sampled."""
    behind = np.linspace(-math.pi, math.pi, 2_000_001)
    angle = 2.0 * math.pi / count + behind
    across = 2.0 * radius**2 * (1.0 - np.cos(angle))
    return math.sqrt((across + (pitch * behind / (2.0 * math.pi)) ** 2).min())


@pytest.mark.parametrize("count", [2, 3, 6, 12])
@pytest.mark.parametrize("pitch", [14.0, 66.0, 400.0])
def test_neighbours_that_wind_touch(count, pitch):
    radius = touching_radius(count, 0.5, False, pitch)
    assert nearest(radius, count, pitch) == pytest.approx(1.0, abs=1e-7)


def test_parallel_neighbours_touch_and_a_central_yarn_counts():
    assert touching_radius(6, 0.5, False) == pytest.approx(1.0)
    assert touching_radius(6, 0.5, True, 20.0) > touching_radius(6, 0.5, True) == pytest.approx(1.0)
    assert touching_radius(3, 0.5, True, 66.0) == 1.0  # the central one keeps them farther apart


def strand(pitch=40.0, elements_per_pitch=16, helix_radius="touching", turns=1):
    return Scene(
        rope=RopeRecipe(pitch=pitch, pitches=1, type="strand"),
        yarn=YarnModel(radius=0.5, elements_per_pitch=elements_per_pitch),
        strand=StrandRecipe(rings=(1, 6), yarn_pitch=f"pitch/{turns}", helix_radius=helix_radius),
    )


def test_a_pitch_without_room_is_refused_with_its_cure():
    """Six of 1 mm need a turn longer than 6 mm; with a radius of one's own they overlap, as the recipe says."""
    with pytest.raises(SceneError, match="strand.yarn_pitch.*use more than 6 mm"):
        build_rope(strand(pitch=6.0))
    build_rope(strand(pitch=6.0, helix_radius=1.2))


def test_a_turn_of_fewer_than_four_spans_is_refused_with_its_cure():
    too_few = strand(elements_per_pitch=4, turns=4)
    least = 16 // too_few.yarn.degree
    with pytest.raises(SceneError, match=f"yarn.elements_per_pitch.*at least {least}"):
        build_rope(too_few)
    build_rope(strand(elements_per_pitch=least, turns=4))
