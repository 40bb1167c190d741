"""Shapes that rods are placed in."""

import numpy as np
import pytest

from braidx.rods import helix


@pytest.mark.parametrize("spans", [8, 16, 32])
def test_a_helix_of_degree_2_keeps_its_distance_from_the_axis(spans):
    """Sampled: parabolas through three nodes each come as near as the radius, and no nearer."""
    nodes = helix(2.0, 30.0, 30.0, spans, phase=0.3, degree=2)
    t = np.linspace(0.0, 1.0, 2001)[:, None]
    first, middle, last = nodes[:-2:2], nodes[1::2], nodes[2::2]
    shape = [(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)]
    nearest = min(
        np.hypot(*(shape[0] * a + shape[1] * b + shape[2] * c)[:, :2].T).min()
        for a, b, c in zip(first, middle, last, strict=True)
    )
    assert nearest == pytest.approx(2.0, rel=1e-6)
    placed_on_it = helix(2.0, 30.0, 30.0, spans, phase=0.3)
    assert np.hypot(*placed_on_it[:, :2].T) == pytest.approx(2.0)
