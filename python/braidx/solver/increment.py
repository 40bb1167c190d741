"""One increment: equilibrium with a consistent pairing, or a clean way back."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..contact.contact import Contact
from ..output.log import LOGGER
from ..system.constraints import Floats
from ..system.proximal import ProximalTerm
from .newton import Newton
from .trial import FIRST_DAMPING, Diverged, Trial

FOLLOW_BELOW = 0.02  # residual with new pairs below which sections follow the yarns
SLOW = 0.5  # reduction of that residual by an update below which updates are damped
GROWTH = 10.0  # largest factor on the penalty of a zone that penetrates too deep, at a time
EXHAUSTED = 3  # times that Newton may run out of iterations in one increment
FORCING = 0.03  # an equilibrium is found to this fraction of the residual that its contact elements started with
REACH = 0.1  # elements that sections may move before the tangent of repeated contact updates needs a new pattern
NEW_POINTS = 1  # contact updates of an increment that may change which point stations there are
UNFOLLOWED = 2  # updates with frozen sections after following ones did not converge


@dataclass(frozen=True)
class IncrementOptions:
    """When an increment is accepted.

    Attributes:
        pairing_tolerance: Relative residual that fresh contact elements may leave in an equilibrium
            found with the ones before; below it the pairing counts as consistent.
        penetration: Largest penetration accepted, mm; None leaves the penalty as it is.
        max_updates: Contact updates before the increment counts as failed.
        most_in_vain: Of them in a row that may leave no smaller residual than one before.
        in_passing: Whether updates may stop at `max_updates` without a consistent pairing, as while
            a rope is formed and each increment is but one step on the way.
    """

    pairing_tolerance: float = 1e-3
    penetration: float | None = None
    max_updates: int = 40
    most_in_vain: int = 40
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


class Incrementer:
    """Solves increments: Newton for given contact elements, new ones until the pairing is consistent.

    Far from the equilibrium sections and normals are frozen during Newton's iteration; near it they follow the
    yarns (engine: facing.h), unless that does not converge. Repetitions that do not approach each other are damped.

    Args:
        newton, contact, proximal: What is solved.
        hold: Damping, N/mm per node, where Newton gets lost in a rope so loose that contact forces are no match for it:
            it holds what would else fly about while contacts are being found, which no line search mends. It vanishes
            with the updates that follow, and does not act on the equilibrium. 0: none.
        conservative: Whether all forces but friction come from a potential, as couples do not.
    """

    def __init__(
        self,
        newton: Newton,
        contact: Contact,
        proximal: ProximalTerm,
        hold: float = 0.0,
        conservative: bool = True,
    ) -> None:
        self.newton, self.contact, self.proximal = newton, contact, proximal
        self.hold, self.conservative = hold, conservative

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
        trial = Trial(guess, loose=self._is_loose(start))
        try:
            while not self._accepted(trial, options):
                self._improve(trial, options.in_passing)
        except Diverged as failure:
            failure.pairs = self.contact.worst_pairs()
            self.contact.restore(before)
            raise
        finally:
            self.proximal.damping = np.zeros_like(guess)
        work = self.proximal.work(trial.q)
        done = self.contact.commit(trial.q)
        return Increment(
            trial.q, trial.iterations, trial.solves, trial.updates, trial.residual, work, *done
        )

    def _is_loose(self, q: Floats) -> bool:
        """Whether contact forces at an equilibrium are no match for the hold."""
        if not self.hold:
            return False
        self.newton.residual(q)
        return self.hold > FIRST_DAMPING * self._contact_stiffness()

    def _contact_stiffness(self) -> float:
        """Contact force of a node over the radius, N/mm, at the state evaluated last."""
        system, num_unknowns = self.newton.system, len(self.newton.directors)
        norm = float(system.term_norms[system.terms.index(self.contact)])
        return norm / float(np.sqrt(max(num_unknowns / 3, 1))) / self.contact.min_radius

    def _accepted(self, trial: Trial, options: IncrementOptions) -> bool:
        """Makes contact elements anew and looks what residual they leave."""
        if options.in_passing and trial.updates >= options.max_updates:
            return True
        last = trial.norm
        self._update(trial)
        consistent = trial.updates > 0 and trial.residual < options.pairing_tolerance
        fresh, trial.raised = trial.raised > 0, 0
        if consistent and options.penetration is not None:
            self._raise_penalties(trial, options.penetration)
        if consistent and not trial.raised:
            return True
        if trial.updates and not consistent and not fresh:
            trial.judge(trial.norm > SLOW * last)
        trial.note(anew=fresh)
        if trial.updates < options.max_updates and trial.in_vain < options.most_in_vain:
            return False
        why = "penetration above tolerance" if trial.raised else f"residual {trial.residual:.1e}"
        raise trial.failed(f"no consistent pairing after {trial.updates} contact updates, {why}")

    def _update(self, trial: Trial) -> None:
        """New contact elements, and the residual they leave."""
        self.contact.pairing.within_increment = trial.updates >= NEW_POINTS
        self.contact.update(trial.q)
        self.proximal.damping = np.zeros_like(trial.q)
        self._measure(trial)

    def _measure(self, trial: Trial) -> None:
        trial.residual = self.newton.residual(trial.q)
        near = trial.residual < FOLLOW_BELOW or trial.slow > 0 or trial.raised > 0
        trial.follows = near and not trial.unfollowed
        if not trial.follows:
            self.contact.freeze_sections()
            # Where sections that follow would leave the places that were just found for them, these count.
            trial.residual = self.newton.residual(trial.q)
        # Of forces that are not there any more at the next state, residuals relative to the present ones tell nothing.
        trial.norm = self.newton.norm

    def _raise_penalties(self, trial: Trial, penetration: float) -> None:
        """Makes zones stiffer that penetrate too deep; yarns will hardly move, so that sections may follow."""
        held = self.newton.system.constraints.held
        trial.raised = self.contact.adapt_stiffness(trial.q, penetration, GROWTH, held)
        if trial.raised:
            self._measure(trial)

    def _improve(self, trial: Trial, in_passing: bool) -> None:
        """Equilibrium for the current contact elements."""
        contact, proximal, system = self.contact, self.proximal, self.newton.system
        proximal.anchor = trial.q
        damping = max(trial.damping * self._contact_stiffness(), trial.held * self.hold)
        proximal.damping = np.where(self.newton.directors, 0.0, damping)
        symmetric = contact.symmetric_tangent and self.conservative
        changed = symmetric != self.newton.symmetric
        self.newton.symmetric = symmetric
        if system.update_pattern() or self.newton.indefinite or changed:
            self.newton.renew()
        # More would be lost at the next update.
        enough = FORCING * trial.residual
        found, result = self.newton.solve(trial.q, enough, search=not trial.loose)
        trial.count(result)
        LOGGER.debug(
            "update %d: residual %.1e before, %d iterations, %d solves, %s; sections %s, damping %.2g N/mm, "
            "%d penalties raised",
            trial.updates,
            trial.residual,
            result.iterations,
            result.linear_solves,
            result.reason,
            "follow" if trial.follows else "frozen",
            damping,
            trial.raised,
        )
        trial.hold(result.converged)
        if not result.converged and trial.follows:
            trial.unfollowed = UNFOLLOWED
            return
        trial.unfollowed = max(0, trial.unfollowed - 1)
        lost = not result.converged and not result.exhausted
        if lost and not trial.loose:
            raise trial.failed(f"Newton: {result.reason} after {result.iterations} iterations")
        trial.exhausted += (lost or result.exhausted) and not in_passing
        if trial.exhausted > EXHAUSTED:
            raise trial.failed(f"Newton: no convergence in {result.iterations} iterations")
        if not lost:
            trial.q = found
