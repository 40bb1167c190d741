"""How strands of a braid wind out and in as they pass over and under each other (paper 2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Undulation:
    """Distance of a strand from its mean helix along the radius, as a function of z.

    It is +amplitude at crossings where the strand is outside and -amplitude where it is inside, goes over from one to
    the other along half a cosine, and stays between crossings of one side. Where sides alternate this is one sine of
    a period of two crossings. Its slope is continuous.
    """

    amplitude: float  # mm
    first: float  # z of crossing 0, mm
    spacing: float  # of the strand's crossings along z, mm
    side: Integers  # (n,), +1: outside at crossings k, k + n, ...; -1: inside

    def offset(self, z: Array) -> Array:
        """Outward distance from the mean helix, shape of z, mm."""
        here, there, along = self._between(z)
        mean, half = (here + there) / 2.0, (here - there) / 2.0
        return self.amplitude * (mean + half * np.cos(np.pi * along))

    def slope(self, z: Array) -> Array:
        """Derivative of `offset`, shape of z."""
        here, there, along = self._between(z)
        half = (here - there) / 2.0
        return -self.amplitude * half * np.pi / self.spacing * np.sin(np.pi * along)

    def _between(self, z: Array) -> tuple[Integers, Integers, Array]:
        """Sides at the crossings before and after z, and how far z is from the one to the other, 0 to 1."""
        along = (np.asarray(z) - self.first) / self.spacing
        before = np.floor(along).astype(np.int64)
        count = len(self.side)
        return self.side[before % count], self.side[(before + 1) % count], along - before
