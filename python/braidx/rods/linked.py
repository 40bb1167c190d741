"""Unknowns that are sums of others, row by row."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..system.constraints import Constraints
from ..system.terms import Floats, Ints


@dataclass(frozen=True)
class Linked:
    """Followers that are sums of leaders.

    Attributes:
        followers: Unknowns, shape (n,).
        leaders: Unknowns, shape (n, k).
        factors: Of the leaders, shape (n, k).
    """

    followers: Ints
    leaders: Ints
    factors: Floats

    @classmethod
    def of(cls, followers: Ints, leaders: Ints, factors: Floats) -> Linked:
        """Vectors, shape (n, 3), that follow vectors, shape (n, k, 3), with factors of shape (n, k)."""
        shape = (*followers.shape, leaders.shape[1])
        of = np.broadcast_to(leaders.transpose(0, 2, 1), shape)
        by = np.broadcast_to(factors[:, None, :], shape)
        width = shape[-1]
        return cls(followers.ravel(), of.reshape(-1, width), by.reshape(-1, width))

    def constrain(self, constraints: Constraints) -> None:
        """Has followers follow."""
        constraints.combine_each(self.followers, self.leaders, self.factors)
