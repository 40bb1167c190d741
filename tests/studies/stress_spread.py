"""How axial stress differs among the yarns of a rope and along them (paper 1, 5.2.2 and figure 20)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from pulled_values import Array

from braidx.output import Snapshot


@dataclass(frozen=True)
class Spread:
    """Axial stress of all yarns over their whole length, each segment counting by its length.

    The sample is periodic: it has no disturbed ends to be left out.
    """

    stress: Array  # (m,), MPa, of all segments
    own_mean: Array  # (m,), MPa, of the yarn that the segment is of
    length: Array  # (m,), mm
    yarn_means: Array  # (num_yarns,), MPa

    @property
    def mean(self) -> float:
        """MPa."""
        return float(np.average(self.stress, weights=self.length))

    @property
    def deviation(self) -> float:
        """Standard deviation, MPa; its square is `among`^2 + `along`^2."""
        return self._deviation(self.stress - self.mean)

    @property
    def among(self) -> float:
        """Standard deviation of the yarns' means, MPa."""
        return self._deviation(self.own_mean - self.mean)

    @property
    def along(self) -> float:
        """Standard deviation from the mean of the own yarn, MPa."""
        return self._deviation(self.stress - self.own_mean)

    @property
    def highest(self) -> float:
        """Largest stress over the mean, -."""
        return float(self.stress.max() / self.mean)

    def _deviation(self, values: Array) -> float:
        return math.sqrt(float(np.average(values**2, weights=self.length)))


def spread(snapshot: Snapshot) -> Spread:
    """Of a state of a rope.

    Raises:
        ValueError: If it has no axial stress.
    """
    if snapshot.axial_stress is None:
        raise ValueError(f"{snapshot.name}: the state has no axial stress")
    lengths = [np.linalg.norm(np.diff(x, axis=0), axis=1) for x in snapshot.centre_lines]
    pairs = list(zip(snapshot.axial_stress, lengths, strict=True))
    means = np.array([np.average(stress, weights=length) for stress, length in pairs])
    return Spread(
        np.concatenate(snapshot.axial_stress),
        np.repeat(means, [len(length) for length in lengths]),
        np.concatenate(lengths),
        means,
    )
