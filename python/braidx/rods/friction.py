"""Friction between each two bodies: rods and rigid surfaces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from ..contact.contact import Contact
from .rigid import FIRST_BODY, RigidSurface


class Friction:
    """Coefficients of friction of pairs of bodies.

    Args:
        contact: Takes them.
        num_rods: Number of rods.
        rigid: Rigid surfaces as they were given; number k goes by -1 - k, as in results of contact. Those that the
            engine made are one body.
        everywhere: Coefficient of all pairs.
    """

    def __init__(
        self,
        contact: Contact,
        num_rods: int,
        rigid: Sequence[RigidSurface | Any],
        everywhere: float,
    ) -> None:
        self._laws, self._num_rods = contact.laws, num_rods
        self._is_ours = [isinstance(surface, RigidSurface) for surface in rigid]
        size = FIRST_BODY + num_rods + len(rigid)
        self._laws.num_bodies = size
        self._laws.friction = np.full(size**2, _coefficient(everywhere)).tolist()

    def between(self, first: int, second: int, coefficient: float) -> None:
        """Sets the coefficient of two bodies, or of a rod with itself; a negative number names a rigid surface.

        Raises:
            IndexError: If there is no such rod or rigid surface.
            ValueError: If a number is no coefficient.
        """
        a, b, value = self._body(first), self._body(second), _coefficient(coefficient)
        table = np.array(self._laws.friction).reshape(self._laws.num_bodies, -1)
        table[a, b] = table[b, a] = value
        self._laws.friction = table.ravel().tolist()

    def of(self, body: int, coefficient: float) -> None:
        """Sets the coefficient of a body with itself and with all others; errors as those of `between`."""
        for other in range(-len(self._is_ours), self._num_rods):
            self.between(body, other, coefficient)

    def _body(self, number: int) -> int:
        if not -len(self._is_ours) <= number < self._num_rods:
            surfaces = ", ".join(str(-1 - k) for k in range(len(self._is_ours))) or "none"
            raise IndexError(
                f"body {number}: there are rods 0 to {self._num_rods - 1}, and rigid surfaces: {surfaces}"
            )
        if number < 0 and not self._is_ours[-1 - number]:
            return 0
        return FIRST_BODY + (number if number >= 0 else self._num_rods - 1 - number)


@contextmanager
def without_friction(contact: Contact) -> Iterator[None]:
    """Nothing rubs for a while."""
    friction = contact.laws.friction
    contact.laws.friction = [0.0] * len(friction)
    try:
        yield
    finally:
        contact.laws.friction = friction


def _coefficient(value: float) -> float:
    number = float(value)
    if not (np.isfinite(number) and number >= 0.0):
        raise ValueError(f"friction is {value}: give a coefficient of 0 or more")
    return number
