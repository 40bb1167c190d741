"""One increment: equilibrium with a consistent pairing, or a clean way back."""

from __future__ import annotations

from dataclasses import dataclass

from ..contact.contact import Contact
from ..system.constraints import Floats
from ..system.terms import ProximalTerm
from .newton import Newton, NewtonResult


@dataclass(frozen=True)
class IncrementOptions:
    """When an increment is accepted.

    Attributes:
        pairing_tolerance: Relative residual that fresh contact elements may leave in an equilibrium
            found with the ones before; below it the pairing counts as consistent.
        penetration: Largest penetration accepted, mm; None leaves the penalty as it is.
        max_updates: Contact updates before the increment counts as failed.
        in_passing: Whether updates may stop at `max_updates` without a consistent pairing, as while
            a rope is formed and each increment is but one step on the way.
    """

    pairing_tolerance: float = 1e-3
    penetration: float | None = None
    max_updates: int = 12
    in_passing: bool = False


@dataclass(frozen=True)
class Increment:
    """An accepted increment.

    Attributes:
        q: Unknowns at its end, shape (num_unknowns,).
        iterations, linear_solves, updates: What it took.
        residual: Relative residual with the final contact elements.
        stabilisation_work: Work taken by the proximal term, mJ.
        friction_work: Work dissipated by friction, mJ.
        penetration: Deepest penetration, mm, at least 0.
        contact_elements: Their number, all processes.
    """

    q: Floats
    iterations: int
    linear_solves: int
    updates: int
    residual: float
    stabilisation_work: float
    friction_work: float
    penetration: float
    contact_elements: int


class Diverged(Exception):
    """An increment found no equilibrium; state and contact history are those of its start.

    Attributes:
        iterations, linear_solves: What the attempt cost.
    """

    def __init__(self, reason: str, iterations: int, linear_solves: int) -> None:
        super().__init__(reason)
        self.iterations, self.linear_solves = iterations, linear_solves


class Incrementer:
    """Solves increments: Newton for frozen contact elements, new ones until the pairing is consistent."""

    def __init__(self, newton: Newton, contact: Contact, proximal: ProximalTerm) -> None:
        self.newton, self.contact, self.proximal = newton, contact, proximal

    def solve(self, start: Floats, guess: Floats, options: IncrementOptions) -> Increment:
        """Goes from the equilibrium `start` to the next one; shapes (num_unknowns,).

        Args:
            start: Unknowns when the increment starts; friction counts slip from there.
            guess: First guess of its end; stabilisation acts against departures from it.
            options: When the increment is accepted.
        Raises:
            Diverged: If there is none to be found; the contact history is rolled back.
        """
        contact = self.contact
        before = contact.elements.copy()
        contact.start, self.proximal.start = start, guess
        q: Floats = guess
        iterations = solves = raised = 0

        def fail(reason: str) -> Diverged:
            contact.restore(before)
            return Diverged(reason, iterations, solves)

        for update in range(options.max_updates + 1):
            contact.update(q)
            residual = self.newton.residual(q)
            consistent = update > 0 and not raised and residual < options.pairing_tolerance
            if consistent or (options.in_passing and update == options.max_updates):
                return Increment(
                    q,
                    iterations,
                    solves,
                    update,
                    residual,
                    self.proximal.work(q),
                    *contact.commit(q),
                )
            if update == options.max_updates:
                break
            self.newton.system.update_pattern()
            self.newton.renew()
            q, result = self._solve_pairs(q)
            iterations += result.iterations
            solves += result.linear_solves
            passed = options.in_passing and result.exhausted
            if not result.converged and not passed:
                raise fail(f"Newton: {result.reason} after {result.iterations} iterations")
            if options.penetration is not None:
                raised = contact.adapt_stiffness(q, options.penetration)
        why = "penetration above tolerance" if raised else f"residual {residual:.1e} with new pairs"
        raise fail(f"pairing not consistent after {options.max_updates} contact updates ({why})")

    def _solve_pairs(self, q: Floats) -> tuple[Floats, NewtonResult]:
        """Newton for the current contact elements; where the exact tangent is indefinite, with a definite one."""
        found, result = self.newton.solve(q)
        if result.converged or not self.contact.pairing.follow:
            return found, result
        self.contact.laws.sliding = False
        try:
            self.newton.renew()
            return self.newton.solve(q)
        finally:
            self.contact.laws.sliding = True
