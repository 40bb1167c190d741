"""Rods, contact, supports and loads as one system, and its equilibria."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from mpi4py import MPI

from ..contact.contact import Contact
from ..output.log import LOGGER
from ..solver.increment import Increment, Incrementer, IncrementOptions
from ..solver.newton import Newton, NewtonOptions
from ..solver.stability import negative_pivots
from ..solver.trial import Diverged
from ..system.global_system import GlobalSystem
from ..system.proximal import ProximalTerm
from ..system.terms import BodyTerm, Floats, Term
from .acting import ActingLoads
from .first_guess import FOLDED, FOLLOWED, follow_supports, refuse_folds
from .folded import refuse_folded, refuse_kinked
from .frames import RigidTerm
from .friction import without_friction
from .held_ends import HeldEnds
from .inertia import InertiaTerm
from .layout import Layout
from .loads import Loads
from .overlap import hidden_overlap
from .passing import refuse_passing
from .path import Impossible
from .supports import Supports

LETTING_GO = 0.1  # share of the viscosity that is left when an increment is solved again
LOOKS = 8  # solutions of an increment, at most
LOST = 0.01  # of forces, and of the way that loads make, what round-off may take


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
        self._carried: Floats = np.zeros(layout.rest.size)  # dead loads of the state accepted last
        self.prepare()

    def prepare(self, inertia: InertiaTerm | None = None) -> None:
        """Puts the system together with the present supports and loads, and with inertia for motion."""
        bodies = zip(self._layout.bodies, self._layout.first_body, strict=True)
        size = self._layout.rest.size
        self._held_ends = HeldEnds(
            self._layout, self._contact, self._supports.is_held, self._options.penetration
        )
        self._acting = ActingLoads(self._layout, self._loads, self._comm.rank)
        self._inertia = inertia
        terms: list[Term] = [BodyTerm(body, int(first)) for body, first in bodies]
        terms += [self._contact, self._proximal, *self._acting.terms]
        terms += [RigidTerm(self._layout.frames, self._comm.rank)]
        terms += [] if inertia is None else [inertia]
        self.system = GlobalSystem(self._comm, terms, self._supports.constraints(), np.zeros(size))
        self._newton = Newton(self.system, self._newton_options, self._layout.is_director)
        conservative = not self._loads.has_followers
        self._incrementer = Incrementer(
            self._newton, self._contact, self._proximal, conservative=conservative
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
        self._held_ends.refuse_overlap(self._supports.advanced(share)[0])
        self._ask_for(share)
        self._newton.options = replace(self._newton_options, round_off=self.round_off(first))
        fitting = self.system.expand(self.system.free_values(first))
        if blind:
            following = follow_supports(self.system, self._layout, self._contact, start, first)
            refuse_folds(self._layout, start, fitting, FOLDED if following is None else FOLLOWED)
            if following is not None:
                self._newton.foresee(start, following)
                fitting = following
        elements, viscosity = self._contact.elements.copy(), self._proximal.viscosity
        self._newton.below_round_off = self._acting.moves(self.system.constraints)
        try:
            found = self._solve(start, fitting, elements)
            refuse_folded(self._layout, found.q)
            refuse_kinked(self._layout, found.q)
            refuse_passing(self._layout, self._contact, start, found.q, leap)
            self._warn_of_depth(found)
            self._carried = self._acting.dead.copy()
        except Diverged as failure:
            rods = self._layout.surface_rods
            failure.pairs = [(rods[a], rods[b] if b >= 0 else b) for a, b in failure.pairs]
            self._contact.restore(elements)
            raise
        finally:
            self._proximal.viscosity = viscosity
        return found

    def _solve(self, start: Floats, guess: Floats, elements: Any) -> Increment:
        """The increment, solved again from what was found as long as that is no equilibrium in truth.

        Places of contact are then looked for anew, and a tenth of the viscosity is left, against departures from there.
        """
        iterations = solves = 0
        for _ in range(LOOKS):
            found = self._incrementer.solve(start, guess, self._options)
            iterations, solves = iterations + found.iterations, solves + found.linear_solves
            wrong = self._what_is_wrong(start, found.q)
            if wrong is None:
                return replace(found, iterations=iterations, linear_solves=solves)
            LOGGER.debug("solved again: %s", wrong)
            self._contact.restore(elements.copy())
            self._proximal.viscosity = LETTING_GO * self._proximal.viscosity
            guess = found.q
        assert wrong is not None
        wrong.iterations, wrong.linear_solves = iterations, solves
        raise wrong

    def _what_is_wrong(self, start: Floats, q: Floats) -> Diverged | None:
        """What makes a state q that was found from `start` no equilibrium, or nothing."""
        depth, a, b = hidden_overlap(self._contact, q)
        if depth:
            a, b = self._layout.surface_rods[[a, b]]
            return Diverged(
                f"rods {a} and {b} overlap by {depth:.3g} mm more than contact sees", 0, 0
            )
        if self._inertia is not None:
            return None
        self._proximal.start = q
        held = self._newton.residual(q)
        if np.any(self._proximal.viscosity) and held > self._options.pairing_tolerance:
            return Diverged(f"viscosity holds {held:.1e} of the forces", 0, 0)
        if self._acting.moves(self.system.constraints) and self._is_lost(q - start):
            return Impossible(
                f"forces of {self.system.force_scale:.2g} N at most are lost in the round-off of internal forces, "
                f"{self._newton.norm:.2g} N: rods so stiff do not feel such loads; give larger ones"
            )
        return None

    def _is_lost(self, way: Floats) -> bool:
        """Whether loads that have changed move rods by no more than the round-off of internal forces does."""
        if np.array_equal(self._acting.dead, self._carried):
            return False
        unbalanced = self._newton.norm > LOST * self.system.force_scale
        return unbalanced and self._newton.step > LOST * float(np.linalg.norm(way))

    def _warn_of_depth(self, found: Increment) -> None:
        """Tells of penetration that no penalty was raised for: what is held cannot give way."""
        allowed = self._options.penetration
        if allowed is not None and found.penetration > allowed:
            LOGGER.warning(
                "held nodes are in each other by %.3g mm, as they were placed: contact forces there are not those of "
                "rods that touch",
                found.penetration,
            )

    def start_moving(self, q: Floats, fresh: bool) -> None:
        """Motion starts at the state q; `fresh`: inertia does not know the forces there yet."""
        assert self._inertia is not None
        self._ask_for(0.0)
        if fresh:
            self._contact.start = self._proximal.start = q
            self._contact.update(q)
            self._inertia.forces = self.forces(q)

    def negative_pivots(self, q: Floats) -> int:
        """Directions in which the state q accepted last is unstable, without stabilisation; a warning tells of them.

        Friction counts with the normal forces that it has there: so it has a potential. Under loads without one it is
        0.
        """
        if not self._acting.tell_stability(self._supports.is_held):
            return 0
        viscosity, symmetrised = self._proximal.viscosity, self._contact.symmetrised
        self._proximal.viscosity, self._contact.symmetrised = np.zeros(q.size), True
        try:
            self.system.set_state(q)
            count = negative_pivots(self.system)
        finally:
            self._proximal.viscosity, self._contact.symmetrised = viscosity, symmetrised
        if count:
            LOGGER.warning(
                "unstable equilibrium: the tangent has %d negative pivots; a small force that is taken away again, or "
                "`run`, leads to a stable one",
                count,
            )
        return count

    @property
    def tolerance(self) -> float:
        """Relative residual at which Newton's iteration ends."""
        return self._newton_options.tolerance

    @property
    def pairing_tolerance(self) -> float:
        """Relative residual at which a state is accepted."""
        return self._options.pairing_tolerance

    def round_off(self, q: Floats) -> float:
        """Norm of what round-off of the positions q leaves of internal forces, N: it grows as rods go far."""
        where = ~self._layout.is_director
        gone = np.abs(q[where]).max() / np.abs(self._layout.rest[where]).max()
        return self._layout.round_off * max(1.0, float(gone))

    def free_part(self, values: Floats) -> Floats:
        """Changes of all unknowns that follow the free ones where supports stand still, shape (num_unknowns,)."""
        constraints = self.system.constraints
        return np.asarray(constraints.transform @ values[constraints.free])

    def out_of_balance(self, q: Floats) -> tuple[Floats, float]:
        """What nothing balances at the begin of the way, shape (num_unknowns,), N, and the largest term's norm, N."""
        self._ask_for(0.0)
        self._contact.start = q
        both, left = self._residual_without(q, self._proximal), np.zeros(q.size)
        left[self.system.constraints.free] = self.system.constraints.reduce(both)
        return left, self.system.force_scale

    def forces(self, q: Floats) -> Floats:
        """Residual of all terms but inertia, of all processes, in the state q, shape (num_unknowns,), N."""
        return self._residual_without(q, self._inertia)

    def unbalanced(self, q: Floats) -> Floats:
        """Residual of all terms but stabilisation at the state accepted last, shape (num_unknowns,), N.

        Inertia counts by the accelerations there, whatever the instant is at which the scheme balances them.
        """
        forces = self._residual_without(q, self._inertia, self._proximal)
        if self._inertia is not None:
            forces += self._inertia.mass * self._inertia.acceleration
        return forces

    def applied(self, q: Floats) -> Floats:
        """Loads and couples as they are at the state accepted last, shape (num_unknowns,), N and N mm."""
        return -self._residual_of(q, self._acting.terms)

    def friction(self, q: Floats) -> Floats:
        """Forces of friction on the rods at the state accepted last, shape (num_unknowns,), N and N mm."""
        if not any(self._contact.laws.friction):
            return np.zeros(q.size)
        everything = self._residual_of(q, [self._contact])
        with without_friction(self._contact):
            normal = self._residual_of(q, [self._contact])
        return normal - everything

    def stop(self, q: Floats, share: float) -> None:
        """Supports, loads and slip are those of the state accepted last, at a share of the way."""
        self._ask_for(share)
        self._contact.start = q

    def _residual_without(self, q: Floats, *left_out: Term | None) -> Floats:
        return self._residual_of(q, [term for term in self.system.terms if term not in left_out])

    def _residual_of(self, q: Floats, terms: list[Term]) -> Floats:
        everything = self.system.terms
        self.system.terms = terms
        self.system.set_state(q)
        residual = self.system.residual()
        self.system.terms = everything
        return self._supports.fold(residual)

    def _ask_for(self, share: float) -> None:
        """Sets supports and loads to a share of the way."""
        self.system.constraint_values = self._supports.values(*self._supports.advanced(share))
        self._acting.ask_for(share)
