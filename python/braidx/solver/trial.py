"""What is known of an increment while its equilibrium is being found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..system.constraints import Floats
from .newton_result import NewtonResult

FIRST_DAMPING = 0.25  # damping over (contact force of a node / radius)
MOST_DAMPING = 1.0  # more would hide the residual rather than remove it
PATIENCE = 4  # damped updates in a row after which it is tried without; twice as many the next time
CALMING = 0.5  # factor on the hold after a solve that converged
HOLDING = 4.0  # and after one that did not


class Diverged(Exception):
    """An increment found no equilibrium; state and contact history are those of its start.

    Attributes:
        iterations, linear_solves: What the attempt cost.
        pairs: Surfaces with the deepest penetrations in the last state that was tried, deepest first.
        sought, cures: What there is none of, and what may help, for messages.
    """

    sought = "equilibrium"
    cures = "more increments, a viscosity, or `run`, if there is no equilibrium near"

    def __init__(self, reason: str, iterations: int, linear_solves: int) -> None:
        super().__init__(reason)
        self.iterations, self.linear_solves = iterations, linear_solves
        self.pairs: list[tuple[int, int]] = []

    @property
    def deepest(self) -> str:
        """The pairs, for a message; rigid surfaces have no numbers."""
        named = (f"{a}-{b}" if b >= 0 else f"{a}-rigid" for a, b in self.pairs)
        return ", ".join(dict.fromkeys(named)) or "none"


@dataclass
class Trial:
    """An increment in the making.

    Attributes:
        q: Unknowns found so far, shape (num_unknowns,).
        loose: Whether it starts from a rope that is held rather than searched for where Newton gets lost.
        residual, norm: With the present contact elements, relative, and in N.
        damping: Of updates that do not approach each other, over (contact force of a node / radius).
        held: Factor on the hold.
        damped: Updates in a row that were damped.
        patience: How many may be.
        slow: Updates in a row that did not approach each other.
        follows: Whether sections follow the yarns in the next solve.
        unfollowed: Updates with frozen sections that are left after following ones did not converge.
        raised: Penalties raised by the last update.
        exhausted: Times that Newton did not converge.
        least, in_vain: Smallest residual until now, and updates since.
        updates, iterations, solves: Done so far.
    """

    q: Floats
    loose: bool
    residual: float = np.inf
    norm: float = np.inf
    damping: float = 0.0
    damped: int = 0
    patience: int = PATIENCE
    held: float = 0.0
    slow: int = 0
    follows: bool = False
    unfollowed: int = 0
    raised: int = 0
    exhausted: int = 0
    least: float = np.inf
    in_vain: int = 0
    updates: int = 0
    iterations: int = 0
    solves: int = 0

    def count(self, result: NewtonResult) -> None:
        self.updates += 1
        self.iterations += result.iterations
        self.solves += result.linear_solves

    def note(self, anew: bool) -> None:
        """Counts updates that leave no smaller residual; where something else has changed, from now on."""
        nearer = anew or self.residual < self.least
        self.in_vain = 0 if nearer else self.in_vain + 1
        self.least = np.inf if anew else min(self.least, self.residual)

    def judge(self, slow: bool) -> None:
        """Damps updates that do not approach each other, and now and then does without.

        What is easily moved, as a rod is that spins or a knot that turns about its line, creeps under a damping to
        where one update would take it, and every bit of its way changes the contact elements.
        """
        grown = min(max(2 * self.damping, FIRST_DAMPING), MOST_DAMPING)
        self.damping = grown if slow else self.damping / 2
        self.damped = self.damped + 1 if self.damping > 0.0 else 0
        if self.damped > self.patience:
            self.damping, self.damped, self.patience = 0.0, 0, 2 * self.patience
        self.slow = self.slow + 1 if slow else 0

    def hold(self, less: bool) -> None:
        """Holds what is loose less, or more."""
        if self.loose:
            self.held = CALMING * self.held if less else max(HOLDING * self.held, 1.0)

    def failed(self, reason: str) -> Diverged:
        return Diverged(reason, self.iterations, self.solves)
