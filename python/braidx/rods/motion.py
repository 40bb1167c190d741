"""Steps of rods through time: how they start, and what has to hold at their ends."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..contact.contact import Contact
from ..solver.increment import Increment
from ..system.terms import Floats
from .energy_balance import EnergyBalance, MakesEnergy, MotionStep
from .equilibria import Equilibria
from .inertia import InertiaTerm, Scheme
from .rod import Rod


def make_inertia(
    rods: Sequence[Rod],
    mass: Floats,
    scheme: Scheme | None,
    velocity: Floats | None,
    last: InertiaTerm | None,
    rank: int,
) -> InertiaTerm:
    """Inertia that goes on with what the last run left, or with a given velocity.

    Raises:
        ValueError: If a rod has no density.
    """
    for number, rod in enumerate(rods):
        if not rod.density > 0.0:
            raise ValueError(
                f"density of rod {number} is {rod.density} t/mm^3: motion needs a positive one"
            )
    inertia = InertiaTerm(mass, scheme or Scheme.generalised_alpha(), rank)
    if last is not None:
        inertia.state = last.state
    if velocity is not None:
        inertia.velocity = np.asarray(velocity, dtype=float).ravel()
    return inertia


class TimeSteps:
    """Finds the states of a run one after the other.

    Attributes:
        last: The step accepted last.
    """

    def __init__(
        self,
        equilibria: Equilibria,
        contact: Contact,
        inertia: InertiaTerm,
        balance: EnergyBalance,
        duration: float,
    ) -> None:
        self._equilibria, self._contact = equilibria, contact
        self._inertia, self._balance, self._duration = inertia, balance, duration
        self.last: MotionStep
        self._fresh = False

    def begin(self, q: Floats, fresh: bool) -> None:
        """The run starts at q; `fresh`: without accelerations of a run before."""
        self._equilibria.start_moving(q, fresh)
        self._fresh = fresh and not self._inertia.scheme.is_backward_euler
        self._balance.begin(q, self._inertia)

    def step(self, q: Floats, begin: float, end: float, time: float) -> Increment:
        """The state at a share `end` of the run, from that at `begin`, which is q at `time` (s).

        Raises:
            Diverged: If there is none, or if the step made energy.
        """
        inertia, elements = self._inertia, self._contact.elements.copy()
        length = (end - begin) * self._duration
        inertia.begin(q, length)
        if self._fresh:
            inertia.acceleration = self._first_acceleration(q, end)
            self._contact.restore(elements.copy())
        increment = self._equilibria.find(q, inertia.predicted(), end)
        before = inertia.state
        self._end(increment.q, q)
        try:
            self.last = self._balance.close(
                increment.q, inertia, increment.friction_work, end, time + length
            )
        except MakesEnergy:
            inertia.state = before
            self._contact.restore(elements)
            raise
        self._fresh = False
        return increment

    def _end(self, q: Floats, start: Floats) -> None:
        """The step has ended at q. What supports drive has the mean velocity of the step, without oscillation."""
        inertia, free_part = self._inertia, self._equilibria.free_part
        was = inertia.velocity - free_part(inertia.velocity)
        moved = q - start
        driven = (moved - free_part(moved)) / inertia.step
        inertia.end(q, self._equilibria.forces(q))
        inertia.velocity = free_part(inertia.velocity) + driven
        inertia.acceleration = free_part(inertia.acceleration) + (driven - was) / inertia.step

    def _first_acceleration(self, q: Floats, share: float) -> Floats:
        """That of a step of the backward Euler method, shape (num_unknowns,), mm/s^2.

        Accelerations in balance with the forces at the start, -M^-1 f, are right only where the step resolves the
        motion. In motions of circular frequency w they are 1 + (w dt)^2 times those here, and a scheme of radius 0 that
        starts with them multiplies the energy of a fast motion by (w dt)^2 / 16. Those here are wrong by the order of
        dt, in one step, so that the scheme stays of second order.
        """
        inertia, scheme = self._inertia, self._inertia.scheme
        inertia.scheme = Scheme.backward_euler()
        try:
            found = self._equilibria.find(q, inertia.predicted(), share)
            return self._equilibria.free_part(inertia.rates(found.q)[1])
        finally:
            inertia.scheme = scheme
