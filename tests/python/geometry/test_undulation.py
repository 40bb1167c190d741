"""Strands that wind out and in: on the side of the motif at every crossing, periodic, and smooth between."""

import numpy as np
import pytest

from braidx.geometry import build_rope, rotations
from braidx.geometry.helix import StrandHelix, climb, place_yarn
from braidx.geometry.strands import strand_helices
from braidx.geometry.undulation import Undulation
from braidx.geometry.undulation_checks import sharpest_bend
from braidx.scene import BraidRecipe, RopeRecipe, Scene, SceneError, StrandRecipe, YarnModel

RADIUS, AMPLITUDE, PITCH = 7.0, 0.9, 96.0


def braid(counts=(6, 6), motif="1-over-1-under", elements=240, pitches=2, rings=(1,), **yarns):
    """With elements a multiple of all numbers of crossings per pitch, so that crossings are at nodes."""
    return Scene(
        rope=RopeRecipe(pitch=PITCH, pitches=pitches),
        braid=BraidRecipe(
            helix_radius=RADIUS,
            strands_per_direction=counts,
            motif=motif,
            undulation=yarns.pop("undulation", AMPLITUDE),
        ),
        strand=StrandRecipe(rings=rings, **yarns),
        yarn=YarnModel(radius=0.3, elements_per_pitch=elements),
    )


def radius_of(line):
    return np.hypot(line[:, 0], line[:, 1])


MOTIFS = [
    ((6, 6), "1-over-1-under"),
    ((6, 6), "2-over-2-under"),
    ((3, 3), "2-over-1-under"),
    ((3, 5), ((1,),)),
    ((2, 6), ((1, -1), (1, 1))),
    ((4, 4), ((1, -1, -1, 1), (1, 1, -1, 1), (-1, 1, 1, 1), (-1, -1, 1, -1))),
]


@pytest.mark.parametrize(("counts", "motif"), MOTIFS)
def test_at_every_crossing_the_outer_strand_is_out_and_the_inner_one_in(counts, motif):
    scene = braid(counts, motif)
    rope, helices = build_rope(scene), strand_helices(scene)[0]
    crossings = rope.crossings
    assert len(crossings) == 4 * counts[0] * counts[1]
    for a, b, z, order, direction in zip(
        crossings.strand_a,
        crossings.strand_b,
        crossings.z,
        crossings.order,
        crossings.direction,
        strict=True,
    ):
        for strand, side in ((a, order), (b, -order)):
            (point,) = helices[strand].point(np.array([z]))
            expected = (RADIUS + side * AMPLITUDE) * direction + [0.0, 0.0, z]
            assert point == pytest.approx(expected, abs=1e-9)
            assert helices[strand]._slope(np.array([z])) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(("counts", "motif"), MOTIFS)
def test_nodes_stay_uniform_in_z_and_lines_repeat_with_the_pitch(counts, motif):
    rope = build_rope(braid(counts, motif))
    for line in rope.centre_lines:
        assert line[:, 2] == pytest.approx(np.linspace(0.0, 2.0 * PITCH, 481), abs=1e-12)
        assert np.allclose(line[:241, :2], line[240:, :2], atol=1e-9)
        assert radius_of(line).max() <= RADIUS + AMPLITUDE + 1e-12
        assert radius_of(line).min() >= RADIUS - AMPLITUDE - 1e-12


def test_one_over_one_under_is_a_sine_of_two_crossings():
    """Paper 2: amplitude r, period 2 p, p being the distance of crossings, here pitch / 12."""
    line = build_rope(braid()).centre_lines[0]
    wave = radius_of(line) - RADIUS
    first = PITCH / 24.0  # ends fall midway between crossings, see test_crossings
    sign = np.sign(wave[5])
    assert wave == pytest.approx(
        sign * AMPLITUDE * np.cos(np.pi * (line[:, 2] - first) / (PITCH / 12.0)), abs=1e-9
    )


def test_between_crossings_of_one_side_a_strand_stays_out():
    line = build_rope(braid(motif="2-over-2-under")).centre_lines[0]
    wave = radius_of(line) - RADIUS
    # of 20 nodes from crossing to crossing and a period of 4 crossings: out and in for 20 each
    assert np.count_nonzero(wave > AMPLITUDE - 1e-9) == 2 * 3 * 21
    assert np.count_nonzero(wave < -AMPLITUDE + 1e-9) in range(2 * 3 * 21 - 21, 2 * 3 * 21 + 22)


def test_slope_is_the_derivative():
    wave = Undulation(0.7, 1.3, 4.0, np.array([1, 1, -1, 1, -1, -1]))
    z = np.random.default_rng(2).uniform(-30.0, 60.0, 200)
    numeric = (wave.offset(z + 1e-6) - wave.offset(z - 1e-6)) / 2e-6
    assert wave.slope(z) == pytest.approx(numeric, abs=1e-6)
    assert wave.offset(z + 24.0) == pytest.approx(wave.offset(z), abs=1e-12)


@pytest.mark.parametrize("turns", [-3, 0, 4])
def test_a_yarn_keeps_its_distance_from_an_undulating_strand(turns):
    wave = Undulation(0.9, 0.4, 8.0, np.array([1, -1]))
    helix, rate = StrandHelix(7.0, 96.0, -1, 0.3, wave), 2.0 * np.pi * turns / 96.0
    z = np.linspace(0.0, 96.0, 60)
    line = place_yarn(helix, 0.6, 0.7, rate, z)
    assert np.array_equal(line[:, 2], z)
    fine = helix.point(np.linspace(-10.0, 106.0, 200001))
    nearest = np.array([np.linalg.norm(fine - node, axis=1).min() for node in line])
    assert nearest == pytest.approx(0.6, abs=1e-6)


@pytest.mark.parametrize("wave", [None, Undulation(0.9, 0.4, 8.0, np.array([1, -1, -1, 1]))])
def test_frames_are_normal_to_the_strand(wave):
    helix, z = StrandHelix(7.0, 96.0, 1, 0.3, wave), np.linspace(0.0, 96.0, 77)
    tangent = (helix.point(z + 1e-5) - helix.point(z - 1e-5)) / 2e-5
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    outward, across = helix.frame(z)
    assert across == pytest.approx(np.cross(tangent, outward), abs=1e-8)
    for vector in (outward, across):
        assert np.einsum("ij,ij->i", vector, vector) == pytest.approx(1.0, abs=1e-12)
        assert np.einsum("ij,ij->i", vector, tangent) == pytest.approx(0.0, abs=1e-8)


def test_climb_is_the_same_formula_with_hardly_any_undulation():
    s = np.linspace(0.0, 96.0, 50)
    flat, hardly = (
        StrandHelix(7.0, 96.0, 1, 0.0, w)
        for w in (None, Undulation(1e-9, 0.0, 8.0, np.array([1, -1])))
    )
    assert climb(hardly, 0.6, 0.1, 0.5, s) == pytest.approx(climb(flat, 0.6, 0.1, 0.5, s), abs=1e-8)


def test_yarns_of_a_strand_follow():
    scene = braid((4, 4), rings=(1, 6), yarn_pitch="pitch/4")
    rope = build_rope(scene)
    for yarn in range(0, rope.num_yarns, 7):
        assert np.allclose(rope.centre_lines[yarn], rope.strand_lines[yarn // 7])
    for line in rope.centre_lines:
        assert np.allclose(line[0, :2], line[-1, :2], atol=1e-9)


@pytest.mark.parametrize(
    ("counts", "motif", "fold"), [((6, 6), "1-over-1-under", 6), ((6, 6), "2-over-2-under", 3)]
)
def test_rotations_are_those_without_undulation(counts, motif, fold):
    for undulation in (0.0, AMPLITUDE):
        rope = build_rope(braid(counts, motif, elements=48, pitches=1, undulation=undulation))
        found = rotations(rope)
        assert found.fold == fold
        assert np.array_equal(np.bincount(found.turns), np.full(fold, 12 // fold))


def test_the_sharpest_bend_of_a_sine_on_a_helix():
    """At the outer crossings those of sine and helix add up: A (pi / p)^2 + sin^2 / (R + A), p along the strand."""
    scene = braid(undulation=0.0)
    slope = 2.0 * np.pi * RADIUS / PITCH
    helix = slope**2 / (1.0 + slope**2) / RADIUS
    assert sharpest_bend(scene) == pytest.approx(1.0 / helix, rel=2e-3)
    slope = 2.0 * np.pi * (RADIUS + AMPLITUDE) / PITCH
    speed = 1.0 + slope**2
    waves = AMPLITUDE * (np.pi * 12.0 / PITCH) ** 2 / speed
    curvature = waves + slope**2 / speed / (RADIUS + AMPLITUDE)
    assert sharpest_bend(braid()) == pytest.approx(1.0 / curvature, rel=2e-3)


def test_a_motif_that_does_not_repeat_with_the_pitch_is_refused():
    build_rope(braid((1, 3), "2-over-2-under", undulation=0.0))
    with pytest.raises(SceneError) as caught:
        build_rope(braid((1, 3), "2-over-2-under"))
    assert "braid.undulation = 0.9: sides of 1 + 3 strands do not repeat" in str(caught.value)
    assert "strands_per_direction = [2, 2]" in str(caught.value)
    build_rope(braid((2, 2), "2-over-2-under"))


def test_yarns_that_would_turn_back_are_refused():
    thick = {"rings": (6,), "helix_radius": 1.3, "elements": 48}
    build_rope(braid(**thick))
    with pytest.raises(SceneError, match="braid.undulation = 5.0: yarns at 1.3 mm from the centre"):
        build_rope(braid(undulation=5.0, **thick))
