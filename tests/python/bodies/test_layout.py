"""Canonical numbering."""

import numpy as np
import pytest

from braidx.bodies.layout import CurveLayout


def test_degree_2_elements_have_their_middle_between_their_ends():
    layout = CurveLayout.from_node_counts([3, 5], 2)
    assert layout.elements.tolist() == [[0, 2, 1], [3, 5, 4], [5, 7, 6]]
    assert layout.curves.tolist() == [0, 3, 8]
    assert layout.curve_elements.tolist() == [0, 1, 3]


def test_degree_1():
    layout = CurveLayout.from_node_counts([3, 2], 1)
    assert layout.elements.tolist() == [[0, 1], [1, 2], [3, 4]]


def test_values_are_spread_over_elements():
    layout = CurveLayout.from_node_counts([3, 2], 1)
    assert layout.per_element(2.0, "x").tolist() == [2.0, 2.0, 2.0]
    assert layout.per_element([1.0, 3.0], "x").tolist() == [1.0, 1.0, 3.0]
    assert layout.per_element([1.0, 2.0, 3.0], "x").tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize("values", [[1.0, 2.0, 3.0, 4.0], np.nan])
def test_bad_values_are_named(values):
    with pytest.raises(ValueError, match="tension"):
        CurveLayout.from_node_counts([3, 2], 1).per_element(values, "tension")


@pytest.mark.parametrize("counts, degree", [([3], 3), ([4], 2), ([5, 1], 1)])
def test_bad_counts(counts, degree):
    with pytest.raises(ValueError):
        CurveLayout.from_node_counts(counts, degree)


@pytest.mark.parametrize("counts", [[5], [3, 9, 5], [3, 3, 101], [41] * 12])
@pytest.mark.parametrize("size", [1, 2, 3, 5])
@pytest.mark.parametrize("degree", [1, 2])
def test_chunks_cover_all_once(counts, size, degree):
    layout = CurveLayout.from_node_counts(counts, degree)
    chunks = [layout.chunk(rank, size) for rank in range(size)]
    for kind, total in ((0, layout.num_elements), (1, layout.num_nodes)):
        covered = np.concatenate([np.arange(total)[chunk[kind]] for chunk in chunks])
        assert covered.tolist() == list(range(total))
    if len(counts) >= size:
        for elements, nodes in chunks:
            assert elements.start in layout.curve_elements
            used = layout.elements[elements]
            assert np.all((used >= nodes.start) & (used < nodes.stop))
