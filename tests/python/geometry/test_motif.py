"""Stacking order: motifs, closure around the cylinder, and paper 1's function as the oracle."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from braidx.geometry.motif import (
    braid_pattern_order,
    check_motif,
    closes,
    motif_matrix,
    stacking_order,
)
from braidx.scene import SceneError


def test_named_motifs():
    assert motif_matrix("1-over-1-under").tolist() == [[1, -1], [-1, 1]]
    assert motif_matrix("2-over-2-under")[:2].tolist() == [[1, 1, -1, -1], [1, -1, -1, 1]]
    assert motif_matrix("2-over-1-under").sum() == 3


def test_a_matrix_is_taken_as_it_is():
    assert motif_matrix(((1, -1, 1),)).tolist() == [[1, -1, 1]]
    with pytest.raises(SceneError, match="rows differ"):
        motif_matrix(((1, -1), (1,)))


def test_a_motif_that_does_not_close_names_sizes_and_cure():
    check_motif(motif_matrix("2-over-2-under"), (6, 6))
    with pytest.raises(SceneError) as caught:
        check_motif(motif_matrix("2-over-2-under"), (5, 5))
    assert "4 x 4" in str(caught.value) and "5 + 5" in str(caught.value)
    assert "[4, 4] or [6, 6]" in str(caught.value)


matrices = st.integers(1, 5).flatmap(
    lambda rows: st.integers(1, 5).flatmap(
        lambda cols: st.lists(
            st.lists(st.sampled_from([-1, 1]), min_size=cols, max_size=cols),
            min_size=rows,
            max_size=rows,
        )
    )
)


@given(matrices, st.integers(1, 7), st.integers(1, 7))
def test_closure_is_agreement_at_every_crossing(rows, n0, n1):
    motif = np.array(rows)
    i, j = np.meshgrid(np.arange(-20, 20), np.arange(-20, 20))
    around = stacking_order(motif, i + n0, j + n1)
    assert closes(motif, (n0, n1)) == np.array_equal(around, stacking_order(motif, i, j))


@given(matrices, st.integers(1, 4), st.integers(1, 4), st.integers(1, 5), st.booleans())
def test_both_ways_around_paper_1_agree(rows, n0, n1, crossing, unrolled):
    """Any closed pattern over the elementary motif, (2 N1, 2 N2), at any crossing of any pair."""
    block = np.resize(np.array(rows), (2 * n0, 2 * n1))
    # made to close: the lower half repeats the upper one, shifted by N2
    block[n0:] = np.roll(block[:n0], n1, axis=1)
    assert closes(block, (n0, n1))
    degrees = 180.0 * crossing if unrolled else 180.0 * (crossing % 2)
    for i in range(n0):
        for j in range(n1):
            shift = (degrees, 66.0 * crossing)
            printed = braid_pattern_order(block, (n0, n1), (i, j), shift, 132.0)
            lines = np.array([i]), np.array([j + crossing * n1])
            assert printed == stacking_order(block, *lines)[0]
