"""Centre lines as smooth curves of their material points."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline

from braidx.output.arrays import Array, Integers

_GAUSS_POINTS, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(8)


class YarnCurves:
    """Cubic splines through the nodes of yarns, as functions of the node index s (real, -).

    A material point keeps its s whatever the rope does. Beyond either end the last cubic goes on.

    Args:
        lines: Per yarn the nodes, shape (n_i, 3) with n_i >= 4, mm.
    """

    def __init__(self, lines: Sequence[Array]) -> None:
        for yarn, line in enumerate(lines):
            if len(line) < 4:
                raise ValueError(f"Yarn {yarn}: {len(line)} nodes; a cubic needs at least 4.")
        self.last = np.array([len(line) - 1 for line in lines])  # largest s per yarn
        self._first = np.concatenate([[0], np.cumsum(self.last)[:-1]])
        pieces = [CubicSpline(np.arange(len(line)), line).c for line in lines]
        self._cubic: Array = np.concatenate(pieces, axis=1)  # (4, segments, 3)

    def __call__(self, yarn: Integers, s: Array, derivative: int = 0) -> Array:
        """Position or its first or second derivative by s at material points, shape (k, 3)."""
        piece = np.clip(np.floor(s).astype(np.int64), 0, self.last[yarn] - 1)
        t = (s - piece)[:, None]
        a, b, c, d = self._cubic[:, self._first[yarn] + piece]
        if derivative == 0:
            value = ((a * t + b) * t + c) * t + d
        elif derivative == 1:
            value = (3 * a * t + 2 * b) * t + c
        else:
            value = 6 * a * t + 2 * b
        return np.asarray(value)

    def tangent(self, yarn: Integers, s: Array) -> Array:
        """Unit tangents, shape (k, 3)."""
        slope = self(yarn, s, 1)
        return np.asarray(slope / np.linalg.norm(slope, axis=1, keepdims=True))

    def arc_length(self, yarn: Integers, start: Array, end: Array) -> Array:
        """Signed length along the yarns from s = start to s = end, shape (k,), mm.

        Gauss's rule over the whole stretch: meant for stretches of an element or so.
        """
        half = 0.5 * (end - start)
        speeds = [
            np.linalg.norm(self(yarn, start + half * (1 + point), 1), axis=1)
            for point in _GAUSS_POINTS
        ]
        return np.asarray(half * (_GAUSS_WEIGHTS @ speeds))
