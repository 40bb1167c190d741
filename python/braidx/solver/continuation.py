"""One increment by pseudo-transient continuation: equilibrium with a consistent pairing, or a clean way back."""

from __future__ import annotations

from ..contact.contact import Contact
from ..output.log import LOGGER
from ..system.constraints import Floats
from .increment import GROWTH, NEW_POINTS, REACH, Increment, IncrementOptions
from .pseudo_transient import PseudoTransient
from .trial import Diverged


class Continuation:
    """Solves increments: contact elements are made anew after each step until they hardly change the forces.

    Args:
        steps: Steps of the whole system.
        contact: Its contact.
        tolerance: Relative residual of an equilibrium.
        most_steps: Steps before the increment counts as failed.
    """

    def __init__(
        self, steps: PseudoTransient, contact: Contact, tolerance: float, most_steps: int
    ) -> None:
        self.steps, self.contact = steps, contact
        self.tolerance, self.most_steps = tolerance, most_steps

    def solve(
        self, start: Floats, guess: Floats, options: IncrementOptions, stiffening: float = 1.0
    ) -> Increment:
        """Goes from the equilibrium `start` to the next one; shapes (num_unknowns,).

        Args:
            start: Unknowns when the increment starts; friction counts slip from there.
            guess: First guess of its end.
            options: When the increment is accepted.
            stiffening: Factor on all penalties. Where tensions are about to grow by it, contact forces then
                do so too, and the guess is in equilibrium without a change of penetrations.
        Raises:
            Diverged: If there is none to be found; the contact history is rolled back.
        """
        contact, steps = self.contact, self.steps
        before, solved = contact.elements.copy(), steps.tangent.solves
        contact.start = start
        contact.forget_pattern()
        steps.tangent.forget()
        contact.reach = REACH
        contact.scale_stiffness(stiffening)
        contact.adopt_stiffness()
        steps.restart(guess)
        steps.symmetric = contact.symmetric_tangent
        self._updates, number = 0, 0
        self._update()
        residual, kept = steps.residual(), False
        while not (kept and residual < self.tolerance):
            if number >= self.most_steps:
                if options.in_passing:
                    break
                failure = Diverged(
                    f"residual {residual:.1e} after {number} steps",
                    number,
                    steps.tangent.solves - solved,
                )
                failure.pairs = contact.worst_pairs()
                contact.restore(before)
                raise failure
            norm, number = steps.norm, number + 1
            if steps.step():
                if not kept:
                    self._update()
                residual = steps.residual()
                steps.adapt(norm, near=kept)
            kept = residual < options.pairing_tolerance
            LOGGER.debug(
                "step %d: residual %.1e, damping parameter %.1e, %s contact elements",
                number,
                residual,
                steps.damping,
                "the same" if kept else "new",
            )
            if kept and self._raise_penalties(options.penetration):
                residual, kept = steps.residual(), False
                steps.damping = 1.0
        done = contact.commit(steps.q)
        solves = steps.tangent.solves - solved
        return Increment(steps.q, number, solves, self._updates, residual, 0.0, *done)

    def _update(self) -> None:
        """New contact elements at the current state."""
        self.contact.pairing.within_increment = self._updates >= NEW_POINTS
        self.contact.update(self.steps.q)
        self._updates += 1

    def _raise_penalties(self, penetration: float | None) -> int:
        """Makes zones stiffer that penetrate deeper than accepted (mm); their number."""
        if penetration is None:
            return 0
        held = self.steps.system.constraints.held
        return self.contact.adapt_stiffness(self.steps.q, penetration, GROWTH, held)
