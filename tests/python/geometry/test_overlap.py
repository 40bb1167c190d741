"""How deep yarns lie in each other: straight rods, and brute force as the oracle."""

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize

from braidx.geometry import build_rope, largest_overlap
from braidx.geometry.overlap import segment_distance
from braidx.scene import RopeRecipe, Scene, StrandRecipe, YarnModel, load_scene

DEMOS = Path(__file__).parents[3] / "demos"


def parallel(distance):
    return build_rope(
        Scene(
            rope=RopeRecipe(pitch=60.0, type="strand"),
            yarn=YarnModel(radius=1.0),
            strand=StrandRecipe(rings=(2,), helix_radius=distance / 2.0),
        )
    )


def test_parallel_yarns():
    assert largest_overlap(parallel(1.9)) == pytest.approx(0.1)
    assert largest_overlap(parallel(2.0)) == pytest.approx(0.0, abs=1e-12)
    assert largest_overlap(parallel(9.0)) == 0.0


@pytest.mark.parametrize("name", ["small_rope", "twisted_strand", "bending_over_sheave"])
def test_brute_force_agrees(name):
    """All pairs of yarns, points every 1/10 of an element."""
    shorter = ["steps.bend.travel=20"] if name == "bending_over_sheave" else []
    rope = build_rope(load_scene(DEMOS / f"{name}.toml", ["rope.pitches=1", *shorter]))
    fine = [
        np.column_stack(
            [np.interp(np.arange(0, len(line) - 0.99, 0.1), range(len(line)), x) for x in line.T]
        )
        for line in rope.centre_lines
    ]
    deepest = 0.0
    for a in range(len(fine)):
        for b in range(a):
            distance = np.linalg.norm(fine[a][:, None] - fine[b][None], axis=2).min()
            deepest = max(deepest, rope.radius[a] + rope.radius[b] - distance)
    spacing = max(np.linalg.norm(np.diff(line, axis=0), axis=1).max() for line in fine)
    assert (
        deepest - 1e-12 <= largest_overlap(rope) <= deepest + spacing
    )  # half of it on either line


def test_distances_of_segments_are_least():
    rng = np.random.default_rng(3)
    points = rng.standard_normal((60, 4, 3))
    points[:10, 3] = points[:10, 1]  # parallel
    found = segment_distance(*points.swapaxes(0, 1))
    for (a, u, b, v), distance in zip(points, found, strict=True):

        def gap(x, a=a, u=u, b=b, v=v):
            return np.sum((b + x[1] * v - a - x[0] * u) ** 2)

        best = min(
            minimize(gap, start, bounds=[(0, 1), (0, 1)], tol=1e-14).fun
            for start in ([0.5, 0.5], [0.0, 1.0], [1.0, 0.0])
        )
        assert distance == pytest.approx(np.sqrt(best), abs=1e-5)
