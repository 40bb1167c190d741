"""Distances of straight pieces of curves."""

from __future__ import annotations

import numpy as np

from ..system.terms import Floats

TINY = float(np.finfo(float).tiny)


def chord_distances(a: Floats, end_a: Floats, b: Floats, end_b: Floats) -> Floats:
    """Of chords from a to end_a from those from b to end_b, which may be points; all shapes (n, 3); shape (n,), mm.

    Source: Ericson, Real-time collision detection (2005), 5.1.9; a second look at `s` sees parallel chords right.
    """
    u, v, w = end_a - a, end_b - b, a - b
    uu, vv = (np.maximum((x * x).sum(-1), TINY**0.25) for x in (u, v))
    uv, uw, vw = (u * v).sum(-1), (u * w).sum(-1), (v * w).sum(-1)
    det = np.maximum(uu * vv - uv**2, 1e-12 * uu * vv)
    s = np.clip((uv * vw - vv * uw) / det, 0.0, 1.0)
    t = np.clip((uv * s + vw) / vv, 0.0, 1.0)
    s = np.clip((uv * t - uw) / uu, 0.0, 1.0)
    return np.asarray(np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=-1))
