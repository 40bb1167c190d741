"""Inertia of rods in implicit steps through time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..system.terms import Floats, Ints


@dataclass(frozen=True)
class Scheme:
    """A step of the generalised-alpha method, of which the backward Euler method is a relative.

    Equilibrium is that of forces at an instant within the step, (1 - alpha_f) of the new ones and alpha_f of the old
    ones, with M ((1 - alpha_m) a_new + alpha_m a_old). Source: Chung, Hulbert, A time integration algorithm for
    structural dynamics with improved numerical dissipation (1993).

    Attributes:
        alpha_m, alpha_f: Old shares of accelerations and of forces, -.
        beta, gamma: Of Newmark's formulas, -.
    """

    alpha_m: float
    alpha_f: float
    beta: float
    gamma: float

    @classmethod
    def generalised_alpha(cls, spectral_radius: float = 0.0) -> Scheme:
        """Second order; of motions too fast for the step a share of `spectral_radius` (0 to 1) is left by each.

        A radius of 0 takes all of them out and balances forces at the end of the step (alpha_f = 0). It then makes no
        energy in contacts that close within a step, where radii of 0.8 and more multiply it.

        Raises:
            ValueError: If the radius is not within 0 and 1.
        """
        rho = spectral_radius
        if not 0.0 <= rho <= 1.0:
            raise ValueError(
                f"spectral_radius is {rho}: give 0 (all fast motion goes) to 1 (all of it stays)"
            )
        alpha_m, alpha_f = (2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0)
        difference = alpha_f - alpha_m
        return cls(alpha_m, alpha_f, 0.25 * (1.0 + difference) ** 2, 0.5 + difference)

    @classmethod
    def backward_euler(cls) -> Scheme:
        """First order; takes energy out of all motions, most out of fast ones. For knots and snap-through."""
        return cls(0.0, 0.0, 1.0, 1.0)

    @property
    def is_backward_euler(self) -> bool:
        """Whether velocities alone, and no accelerations, are carried from step to step."""
        return self.beta == self.gamma == 1.0


class InertiaTerm:
    """Forces of inertia at the end of a step of time, and what is left of the forces at its begin.

    With v_new = v + dt ((1 - gamma) a + gamma a_new) and q_new = q + dt v + dt^2 ((1/2 - beta) a + beta a_new); of
    backward Euler (beta = gamma = 1) only q_new - q = dt v_new and v_new - v = dt a_new count.

    Attributes:
        mass: Of each unknown, shape (num_unknowns,); t on positions.
        velocity, acceleration: At the begin of the step, mm/s and mm/s^2.
        forces: Residual of all other terms there, N.
    """

    pattern_version = 1
    spread = None

    def __init__(self, mass: Floats, scheme: Scheme, rank: int = 0) -> None:
        self.mass, self.scheme = mass, scheme
        self.velocity: Floats = np.zeros(mass.size)
        self.acceleration: Floats = np.zeros(mass.size)
        self.forces: Floats = np.zeros(mass.size)
        self._mine: Ints = np.arange(mass.size if rank == 0 else 0)
        self._q: Floats = np.zeros(mass.size)
        self._start: Floats = self._q
        self._step = np.inf

    @property
    def step(self) -> float:
        """Length of the step, s."""
        return self._step

    @property
    def state(self) -> tuple[Floats, Floats, Floats]:
        """Velocity, acceleration and forces at the begin of the step."""
        return self.velocity, self.acceleration, self.forces

    @state.setter
    def state(self, state: tuple[Floats, Floats, Floats]) -> None:
        self.velocity, self.acceleration, self.forces = state

    def begin(self, q: Floats, step: float) -> None:
        """A step of `step` seconds starts at q."""
        self._start, self._step = q, step

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self._q = q

    def rates(self, q: Floats) -> tuple[Floats, Floats]:
        """Velocity and acceleration at the end of the step, if that is at q."""
        s, dt = self.scheme, self._step
        moved: Floats = np.asarray(q - self._start)
        if s.is_backward_euler:
            velocity: Floats = np.asarray(moved / dt)
            return velocity, np.asarray((velocity - self.velocity) / dt)
        acceleration: Floats = np.asarray((moved / dt - self.velocity) / (s.beta * dt))
        acceleration -= (0.5 / s.beta - 1.0) * self.acceleration
        mean = (1.0 - s.gamma) * self.acceleration + s.gamma * acceleration
        return np.asarray(self.velocity + dt * mean), acceleration

    def predicted(self) -> Floats:
        """Where the unknowns are at the end of a step without new forces, shape (num_unknowns,)."""
        return np.asarray(self._start + self._step * self.velocity)

    def end(self, q: Floats, forces: Floats) -> None:
        """The step has ended at q, with the residual `forces` of all other terms."""
        self.velocity, self.acceleration = self.rates(q)
        self.forces = forces

    def energy(self, own: Floats) -> float:
        """See Term: of forces that are linear in the unknowns, counted from the begin of the step."""
        mean = 0.5 * (self._forces(self._q) + self._forces(self._start))
        return float((mean * (self._q - self._start))[self._mine].sum())

    def add_residual(self, residual: Floats) -> None:
        """See Term; the forces are given to one process only."""
        residual[self._mine] += self._forces(self._q)[self._mine]

    def _forces(self, q: Floats) -> Floats:
        s = self.scheme
        _, acceleration = self.rates(q)
        mean = (1.0 - s.alpha_m) * acceleration + s.alpha_m * self.acceleration
        return np.asarray((self.mass * mean + s.alpha_f * self.forces) / (1.0 - s.alpha_f))

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return self._mine, self._mine

    def tangent_values(self) -> Floats:
        """See Term."""
        s = self.scheme
        factor = (1.0 - s.alpha_m) / ((1.0 - s.alpha_f) * s.beta * self._step**2)
        return np.asarray(factor * self.mass[self._mine])
