"""One increment: equilibrium with a consistent pairing, or a clean way back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..contact.contact import Contact
from ..output.log import LOGGER
from ..system.constraints import Floats
from ..system.proximal import ProximalTerm
from .newton import Newton, NewtonResult

FOLLOW_BELOW = 0.02  # residual with new pairs below which sections follow the yarns
SLOW = 0.5  # reduction of that residual by an update below which updates are damped
MOST_DAMPING = 1.0  # more would hide the residual rather than remove it
CALMING, HOLDING = (
    0.5,
    4.0,
)  # factors on the hold of a loose rope after a solve that converged, or did not
FIRST_DAMPING = 0.25  # damping over (contact force of a node / radius)
GROWTH = 10.0  # largest factor on the penalty of a zone that penetrates too deep, at a time
EXHAUSTED = 3  # times that Newton may run out of iterations in one increment
FORCING = 0.03  # an equilibrium is found to this fraction of the residual that its contact elements started with
REACH = 0.1  # elements that sections may move before the tangent of repeated contact updates needs a new pattern
NEW_POINTS = 1  # contact updates of an increment that may change which point stations there are
RELEASES = 4  # times that the stabilisation may let go in one increment
UNFOLLOWED = 2  # updates with frozen sections after following ones did not converge


@dataclass(frozen=True)
class IncrementOptions:
    """When an increment is accepted.

    Attributes:
        pairing_tolerance: Relative residual that fresh contact elements may leave in an equilibrium
            found with the ones before; below it the pairing counts as consistent.
        penetration: Largest penetration accepted, mm; None leaves the penalty as it is.
        stabilisation: Work of the stabilisation above which it lets go, mJ: it then acts against departures from
            the state found, until the next one is near. None: it never does.
        max_updates: Contact updates before the increment counts as failed.
        in_passing: Whether updates may stop at `max_updates` without a consistent pairing, as while
            a rope is formed and each increment is but one step on the way.
    """

    pairing_tolerance: float = 1e-3
    penetration: float | None = None
    stabilisation: float | None = None
    max_updates: int = 40
    in_passing: bool = False


@dataclass(frozen=True)
class Increment:
    """An accepted increment.

    Attributes:
        q: Unknowns at its end, shape (num_unknowns,).
        iterations, linear_solves, updates: What it took.
        residual: Relative residual with the final contact elements.
        stabilisation_work: Work that the proximal term takes in the equilibrium found, mJ.
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
    """Solves increments: Newton for given contact elements, new ones until the pairing is consistent.

    Far from the equilibrium sections and normals are frozen during Newton's iteration; near it they follow the
    yarns (engine: facing.h), unless that does not converge. Repetitions that do not approach each other are damped.

    Args:
        newton, contact, proximal: What is solved.
        hold: Damping, N/mm per node, where Newton gets lost in a rope so loose that contact forces are no match for it:
            it holds what would else fly about while contacts are being found, which no line search mends. It vanishes
            with the updates that follow, and does not act on the equilibrium. 0: none.
    """

    def __init__(
        self,
        newton: Newton,
        contact: Contact,
        proximal: ProximalTerm,
        hold: float = 0.0,
    ) -> None:
        self.newton, self.contact, self.proximal = newton, contact, proximal
        self.hold = hold

    def solve(
        self, start: Floats, guess: Floats, options: IncrementOptions, stiffening: float = 1.0
    ) -> Increment:
        """Goes from the equilibrium `start` to the next one; shapes (num_unknowns,).

        Args:
            start: Unknowns when the increment starts; friction counts slip from there.
            guess: First guess of its end; stabilisation acts against departures from it.
            options: When the increment is accepted.
            stiffening: Factor on all penalties. Where tensions are about to grow by it, contact forces then
                do so too, and the guess is in equilibrium without a change of penetrations.
        Raises:
            Diverged: If there is none to be found; the contact history is rolled back.
        """
        before = self.contact.elements.copy()
        self.contact.start, self.proximal.start = start, guess
        self.contact.forget_pattern()
        self.newton.forget()
        self.contact.reach = 0.0 if options.in_passing else REACH
        self.contact.scale_stiffness(stiffening)
        if options.penetration is not None:
            self.contact.adopt_stiffness()
        attempt = _Attempt(guess)
        try:
            while not self._accepted(attempt, options) or self._lets_go(attempt, options):
                self._improve(attempt, options.in_passing)
        except Diverged:
            self.contact.restore(before)
            raise
        finally:
            self.proximal.damping = np.zeros_like(guess)
        work = self.proximal.work(attempt.q)
        done = self.contact.commit(attempt.q)
        return Increment(
            attempt.q,
            attempt.iterations,
            attempt.solves,
            attempt.updates,
            attempt.residual,
            work,
            *done,
        )

    def _accepted(self, attempt: _Attempt, options: IncrementOptions) -> bool:
        """Makes contact elements anew and looks what residual they leave."""
        if options.in_passing and attempt.updates >= options.max_updates:
            return True
        last = attempt.norm
        self._update(attempt)
        consistent = attempt.updates > 0 and attempt.residual < options.pairing_tolerance
        fresh, attempt.raised = attempt.raised > 0, 0
        if consistent and options.penetration is not None:
            self._raise_penalties(attempt, options.penetration)
        if consistent and not attempt.raised:
            return True
        if attempt.updates and not consistent and not fresh:
            attempt.judge(attempt.norm > SLOW * last)
        if attempt.updates < options.max_updates:
            return False
        why = (
            "penetration above tolerance" if attempt.raised else f"residual {attempt.residual:.1e}"
        )
        raise attempt.failed(
            f"no consistent pairing after {attempt.updates} contact updates, {why}"
        )

    def _lets_go(self, attempt: _Attempt, options: IncrementOptions) -> bool:
        """Whether the stabilisation still holds the state found, which it lets go then."""
        most = np.inf if options.stabilisation is None else options.stabilisation
        if attempt.releases >= RELEASES or self.proximal.work(attempt.q) <= most:
            return False
        attempt.releases += 1
        self.proximal.start = attempt.q
        self._measure(attempt)
        # What it held may be less than what an equilibrium may leave.
        return attempt.residual >= options.pairing_tolerance

    def _update(self, attempt: _Attempt) -> None:
        """New contact elements, and the residual they leave."""
        self.contact.pairing.keep_points = attempt.updates >= NEW_POINTS
        self.contact.update(attempt.q)
        self.proximal.damping = np.zeros_like(attempt.q)
        self._measure(attempt)

    def _measure(self, attempt: _Attempt) -> None:
        attempt.residual = self.newton.residual(attempt.q)
        near = attempt.residual < FOLLOW_BELOW or attempt.slow > 0 or attempt.raised > 0
        attempt.follows = near and not attempt.unfollowed
        if not attempt.follows:
            self.contact.freeze_sections()
            # Where sections that follow would leave the places that were just found for them, these count.
            attempt.residual = self.newton.residual(attempt.q)
        # Of forces that are not there any more at the next state, residuals relative to the present ones tell nothing.
        attempt.norm = self.newton.norm

    def _raise_penalties(self, attempt: _Attempt, penetration: float) -> None:
        """Makes zones stiffer that penetrate too deep; yarns will hardly move, so that sections may follow."""
        attempt.raised = self.contact.adapt_stiffness(attempt.q, penetration, GROWTH)
        if attempt.raised:
            self._measure(attempt)

    def _improve(self, attempt: _Attempt, in_passing: bool) -> None:
        """Equilibrium for the current contact elements."""
        contact, proximal, system = self.contact, self.proximal, self.newton.system
        proximal.anchor = attempt.q
        force = system.term_norms[system.terms.index(contact)] / np.sqrt(max(len(attempt.q) / 3, 1))
        stiffness = force / contact.min_radius
        loose = self.hold > FIRST_DAMPING * stiffness
        damping = max(attempt.damping * stiffness, attempt.held * self.hold)
        proximal.damping = np.where(self.newton.directors, 0.0, damping)
        symmetric = contact.symmetric_tangent
        changed = symmetric != self.newton.symmetric
        self.newton.symmetric = symmetric
        if system.update_pattern() or self.newton.indefinite or changed:
            self.newton.renew()
        # More would be lost at the next update.
        enough = FORCING * attempt.residual
        found, result = self.newton.solve(attempt.q, enough, search=not loose)
        attempt.count(result)
        LOGGER.debug(
            "update %d: residual %.1e before, %d iterations, %d solves, %s; sections %s, damping %.2g N/mm, "
            "%d penalties raised",
            attempt.updates,
            attempt.residual,
            result.iterations,
            result.linear_solves,
            result.reason,
            "follow" if attempt.follows else "frozen",
            damping,
            attempt.raised,
        )
        attempt.held = (
            CALMING * attempt.held if result.converged else max(HOLDING * attempt.held, 1.0)
        )
        if not result.converged and attempt.follows:
            attempt.unfollowed = UNFOLLOWED
            return
        attempt.unfollowed = max(0, attempt.unfollowed - 1)
        lost = not result.converged and not result.exhausted
        if lost and not loose:
            raise attempt.failed(f"Newton: {result.reason} after {result.iterations} iterations")
        attempt.exhausted += (lost or result.exhausted) and not in_passing
        if attempt.exhausted > EXHAUSTED:
            raise attempt.failed(f"Newton: no convergence in {result.iterations} iterations")
        if not lost:
            attempt.q = found


@dataclass
class _Attempt:
    """An increment in the making."""

    q: Floats
    residual: float = np.inf
    norm: float = np.inf
    damping: float = 0.0
    held: float = 0.0
    slow: int = 0
    follows: bool = False
    unfollowed: int = 0
    raised: int = 0
    exhausted: int = 0
    releases: int = 0
    updates: int = 0
    iterations: int = 0
    solves: int = 0

    def count(self, result: NewtonResult) -> None:
        self.updates += 1
        self.iterations += result.iterations
        self.solves += result.linear_solves

    def judge(self, slow: bool) -> None:
        """Damps updates that do not approach each other."""
        grown = min(max(2 * self.damping, FIRST_DAMPING), MOST_DAMPING)
        self.damping = grown if slow else self.damping / 2
        self.slow = self.slow + 1 if slow else 0

    def failed(self, reason: str) -> Diverged:
        return Diverged(reason, self.iterations, self.solves)
