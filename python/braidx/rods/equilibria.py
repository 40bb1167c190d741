"""Rods, contact, supports and loads as one system, and its equilibria."""

from __future__ import annotations

import numpy as np
from mpi4py import MPI

from ..contact.contact import Contact
from ..solver.increment import Increment, Incrementer, IncrementOptions
from ..solver.newton import Newton, NewtonOptions
from ..solver.trial import Diverged
from ..system.global_system import GlobalSystem
from ..system.proximal import ProximalTerm
from ..system.terms import BodyTerm, Floats, LoadTerm, Term
from .couples import CoupleTerm
from .first_guess import FOLDED, FOLLOWED, follow_supports, refuse_folds
from .folded import refuse_folded
from .inertia import InertiaTerm
from .layout import Layout
from .loads import Loads
from .passing import refuse_passing
from .supports import Supports


class Equilibria:
    """Finds equilibria at shares of the way to what supports and loads ask for.

    Attributes:
        system: Of the supports as they were when `prepare` was called last.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        layout: Layout,
        contact: Contact,
        proximal: ProximalTerm,
        supports: Supports,
        loads: Loads,
        newton: NewtonOptions,
        options: IncrementOptions,
    ) -> None:
        self._comm, self._layout = comm, layout
        self._contact, self._proximal = contact, proximal
        self._supports, self._loads = supports, loads
        self._newton_options, self._options = newton, options
        self._inertia: InertiaTerm | None = None
        self.prepare()

    def prepare(self, inertia: InertiaTerm | None = None) -> None:
        """Puts the system together with the present supports and loads, and with inertia for motion."""
        bodies = zip(self._layout.bodies, self._layout.first_body, strict=True)
        size = self._layout.rest.size
        self._dead = LoadTerm(size, self._comm.rank)
        self._couples = CoupleTerm(self._loads.directors(), self._comm.rank)
        self._inertia = inertia
        terms: list[Term] = [BodyTerm(body, int(first)) for body, first in bodies]
        terms += [self._contact, self._proximal, self._dead, self._couples]
        terms += [] if inertia is None else [inertia]
        self.system = GlobalSystem(self._comm, terms, self._supports.constraints(), np.zeros(size))
        self._newton = Newton(self.system, self._newton_options, self._layout.is_director)
        self._incrementer = Incrementer(
            self._newton, self._contact, self._proximal, conservative=not self._loads.has_couples
        )

    def find(
        self, start: Floats, first: Floats, share: float, blind: bool = False, leap: bool = False
    ) -> Increment:
        """The equilibrium at a share of the way.

        Args:
            start: The one before, shape (num_unknowns,).
            first: First guess; held unknowns go where they are asked to go.
            blind: Whether the guess knows nothing of where they go, and may fold elements beside them.
            leap: Whether rods may get there by any way, through each other, too.
        Raises:
            Diverged: If there is none to be found.
        """
        self._ask_for(share)
        fitting = self.system.expand(self.system.free_values(first))
        if blind:
            following = follow_supports(self.system, self._layout, self._contact, start, first)
            refuse_folds(self._layout, start, fitting, FOLDED if following is None else FOLLOWED)
            if following is not None:
                self._newton.foresee(start, following)
                fitting = following
        elements = self._contact.elements.copy()
        found = self._incrementer.solve(start, fitting, self._options)
        try:
            refuse_folded(self._layout, found.q)
            if not leap:
                refuse_passing(self._layout, self._contact, start, found.q)
        except Diverged:
            self._contact.restore(elements)
            raise
        return found

    def start_moving(self, q: Floats) -> None:
        """Gives inertia the forces on the state q, and the accelerations that go with them."""
        assert self._inertia is not None
        self._ask_for(0.0)
        self._contact.start = self._proximal.start = q
        self._contact.update(q)
        forces, free = self.forces(q), self.system.constraints.free
        acceleration: Floats = np.zeros(q.size)
        acceleration[free] = -forces[free] / self._inertia.mass[free]
        self._inertia.forces, self._inertia.acceleration = forces, acceleration

    def forces(self, q: Floats) -> Floats:
        """Residual of all terms but inertia, of all processes, in the state q, shape (num_unknowns,), N."""
        terms = self.system.terms
        self.system.terms = [term for term in terms if term is not self._inertia]
        self.system.set_state(q)
        forces = self.system.residual()
        self.system.terms = terms
        return forces

    def _ask_for(self, share: float) -> None:
        """Sets supports and loads to a share of the way."""
        self.system.constraint_values = self._supports.values(*self._supports.advanced(share))
        self._dead.loads[:], self._couples.couples = self._loads.at(share)
