"""Stabilisation: viscous forces against departures from the predicted state, and damping of contact updates."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from .terms import Floats, Ints
from .turning import Turning


class ProximalTerm:
    """Stabilisation of unknowns: a viscous force against departures from the predicted state, which is reported,
    and a damping of the repetition of contact updates, which vanishes when that comes to rest.

    Attributes:
        viscosity: Per unknown, N/mm for positions (N mm per director unit), shape (num_unknowns,).
        start: Predicted unknowns of the increment, shape (num_unknowns,).
        damping: Per unknown, in the same units, shape (num_unknowns,).
        anchor: Unknowns at the last contact update, shape (num_unknowns,).
        turning: The same for tangents of cables, None for what has directors of its own.
    """

    pattern_version = 1
    spread = None

    def __init__(self, num_unknowns: int, rank: int = 0, turning: Turning | None = None) -> None:
        self.turning = turning
        self._turns = turning if rank == 0 else None
        self.viscosity: Floats = np.zeros(num_unknowns)
        self.damping: Floats = np.zeros(num_unknowns)
        self.start: Floats = np.zeros(num_unknowns)
        self.anchor: Floats = self.start
        self._q: Floats = self.start
        self._mine = np.arange(num_unknowns if rank == 0 else 0)

    def set_viscosity(self, is_director: np.ndarray, positions: float, directors: float) -> None:
        """N/mm on positions, N mm per radian on directors, or on the tangents of cables.

        Args:
            is_director: Whether an unknown belongs to a director, shape (num_unknowns,).
        """
        self.viscosity[:] = np.where(is_director, directors, positions)
        if self.turning:
            self.turning.viscosity = directors

    @contextmanager
    def scaled(self, factor: float) -> Iterator[None]:
        """Multiplies the viscosity for as long as the context lasts."""
        kept, turned = self.viscosity, self.turning.viscosity if self.turning else 0.0
        self.viscosity = factor * kept
        if self.turning:
            self.turning.viscosity = factor * turned
        try:
            yield
        finally:
            self.viscosity = kept
            if self.turning:
                self.turning.viscosity = turned

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._q = q

    def energy(self, own: Floats) -> float:
        """See Term."""
        each = self.viscosity * (self._q - self.start) ** 2
        each += self.damping * (self._q - self.anchor) ** 2
        turned = self._turns.work(self._q - self.start, own) if self._turns else 0.0
        return 0.5 * (float((own * each)[self._mine].sum()) + turned)

    def add_residual(self, residual: Floats) -> None:
        """See Term; the forces are given to one process only."""
        forces = self.viscosity * (self._q - self.start) + self.damping * (self._q - self.anchor)
        residual[self._mine] += forces[self._mine]
        if self._turns:
            self._turns.add_forces(self._q - self.start, residual)

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        if not self._turns:
            return self._mine, self._mine
        rows, cols = self._turns.pattern()
        return np.concatenate([self._mine, rows]), np.concatenate([self._mine, cols])

    def tangent_values(self) -> Floats:
        """See Term."""
        values = (self.viscosity + self.damping)[self._mine]
        return np.concatenate([values, self._turns.values()]) if self._turns else values

    def work(self, q: Floats) -> float:
        """Work that the viscous forces take on the way from the prediction to q, N mm = mJ."""
        moved = q - self.start
        turned = self.turning.work(moved) if self.turning else 0.0
        return float(self.viscosity @ moved**2) + turned
