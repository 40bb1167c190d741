"""Crossings: found where the strands' centre lines meet, with the order of the motif."""

import numpy as np
import pytest

from braidx.geometry import build_rope
from braidx.geometry.crossings import find_crossings
from braidx.geometry.motif import motif_matrix
from braidx.scene import BraidRecipe, RopeRecipe, Scene, YarnModel


def braid(counts, motif, pitches=2):
    return Scene(
        rope=RopeRecipe(pitch=132.0, pitches=pitches),
        braid=BraidRecipe(helix_radius=7.0, strands_per_direction=counts, motif=motif),
        yarn=YarnModel(radius=0.3, elements_per_pitch=200),
    )


@pytest.mark.parametrize("counts", [(6, 6), (2, 6), (3, 5), (1, 3)])
def test_strands_meet_at_every_crossing_and_nowhere_else(counts):
    rope = build_rope(braid(counts, ((1,),)))
    crossings = rope.crossings
    assert len(crossings) == 4 * counts[0] * counts[1]  # every pair, twice per pitch
    assert np.all((crossings.z > 0) & (crossings.z < rope.length))
    assert np.all(np.diff(crossings.z) > -1e-9)
    for strands in (crossings.strand_a, crossings.strand_b):
        for strand, z, direction in zip(strands, crossings.z, crossings.direction, strict=True):
            line = rope.strand_lines[strand]
            point = [np.interp(z, line[:, 2], line[:, axis]) for axis in range(3)]
            assert np.allclose(point, 7.0 * direction + [0, 0, z], atol=0.01)
    assert np.all(rope.layer[crossings.strand_a] == 0)
    assert np.all(rope.layer[crossings.strand_b] == 1)


def test_ends_fall_midway_between_rings_of_crossings():
    rings = np.unique(np.round(build_rope(braid((6, 6), "2-over-2-under")).crossings.z, 6))
    assert np.allclose(np.diff(rings), 11.0)
    assert rings[0] == pytest.approx(5.5) and rings[-1] == pytest.approx(264.0 - 5.5)


def test_every_strand_goes_over_two_and_under_two():
    crossings = build_rope(braid((6, 6), "2-over-2-under")).crossings
    for strand in range(12):
        of_strand = (crossings.strand_a == strand) | (crossings.strand_b == strand)
        runs = np.diff(np.flatnonzero(np.diff(crossings.order[of_strand])))
        assert np.all(runs == 2)


def test_ribs_of_a_named_motif_run_along_the_axis():
    crossings = build_rope(braid((6, 6), "2-over-2-under")).crossings
    angle = np.arctan2(crossings.direction[:, 1], crossings.direction[:, 0])
    column = np.round(angle / (np.pi / 12)).astype(int) % 24
    for value in np.unique(column):
        assert len(set(crossings.order[column == value])) == 1


def test_the_order_repeats_with_the_pitch():
    motif = motif_matrix("2-over-2-under")
    one = find_crossings(motif, (6, 6), pitch=132.0, length=132.0)
    two = find_crossings(motif, (6, 6), pitch=132.0, length=264.0)
    assert np.array_equal(two.order[72:], one.order)
    assert np.array_equal(two.strand_a[:72], one.strand_a)
