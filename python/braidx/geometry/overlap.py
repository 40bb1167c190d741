"""How deep yarns lie in each other in the start configuration."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from braidx.geometry.rope import Rope

Array = NDArray[np.float64]


def largest_overlap(rope: Rope) -> float:
    """Largest penetration of two yarns, mm: sum of radii less distance of centre lines; 0 where none overlap."""
    lines = rope.centre_lines
    start = np.concatenate([line[:-1] for line in lines])
    along = np.concatenate([np.diff(line, axis=0) for line in lines])
    yarn = np.repeat(np.arange(len(lines)), [len(line) - 1 for line in lines])
    reach = 2.0 * float(rope.radius.max()) + float(np.linalg.norm(along, axis=1).max())
    pairs = cKDTree(start + along / 2.0).query_pairs(reach, output_type="ndarray")
    a, b = pairs[yarn[pairs[:, 0]] != yarn[pairs[:, 1]]].T
    if len(a) == 0:
        return 0.0
    distance = segment_distance(start[a], along[a], start[b], along[b])
    return max(0.0, float((rope.radius[yarn[a]] + rope.radius[yarn[b]] - distance).max()))


def segment_distance(start_a: Array, along_a: Array, start_b: Array, along_b: Array) -> Array:
    """Distances of pairs of segments start + [0, 1] along, shape (n,); arguments (n, 3), lengths above 0."""
    between = start_b - start_a
    aa, bb = _dot(along_a, along_a), _dot(along_b, along_b)
    ab, a0, b0 = _dot(along_a, along_b), _dot(along_a, between), _dot(along_b, between)
    det = aa * bb - ab**2
    skew = det > 1e-12 * aa * bb
    s = np.where(skew, (a0 * bb - b0 * ab) / np.where(skew, det, 1.0), 0.0).clip(0.0, 1.0)
    t = ((s * ab - b0) / bb).clip(0.0, 1.0)
    s = ((t * ab + a0) / aa).clip(0.0, 1.0)
    gap = between + t[:, None] * along_b - s[:, None] * along_a
    return np.asarray(np.linalg.norm(gap, axis=1))


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))
