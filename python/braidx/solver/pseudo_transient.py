"""Pseudo-transient continuation: steps towards an equilibrium that are damped, and leave nothing of it in the result.

Kelley, Keyes: Convergence analysis of pseudo-transient continuation, SIAM J. Numer. Anal. 35 (1998) 508-523.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from ..system.proximal import ProximalTerm
from .linear import FactorisedTangent

LEAST = 1e-4  # of the damping parameter: the softest mode of a yarn of n nodes has (pi / n)^2, more up to n = 300;
# rigid motions that nothing resists are still damped
MOST = 1e6  # steps are a millionth of the way that tensions ask for: nothing moves any more
SUFFICIENT = 1e-4  # of the decrease that the slope foretells (Armijo; Nocedal, Wright, ch. 3)
ROUND_OFF = 1e-12  # of the potential: a sum of some ten thousand terms is not more exact
HALVINGS = 8  # of a step before the direction counts as none, and
NEARER = 0.1  # see `adapt`
STRONGER = 10.0  # factor on the damping parameter for the next one


@dataclass(frozen=True)
class StepOptions:
    """Limits of steps.

    Attributes:
        max_step: Largest change of a position in a step, mm; longer steps are scaled down.
        max_turn: Largest change of a director component; likewise.
        least_force: Force scale that counts at least, N.
    """

    max_step: float = np.inf
    max_turn: float = np.inf
    least_force: float = 0.0


class PseudoTransient:
    """Steps (K + s D) dq = -R from state to state, with the true residual R.

    D is the metric of `proximal`, whose forces are no part of R: it starts from where each step does. A step
    is halved until the potential falls. The damping parameter s follows the residual.

    Attributes:
        q: The current unknowns, shape (num_unknowns,).
        norm: Norm of the residual there, N.
        damping: The parameter s.
        symmetric: Whether the tangent is.

    Args:
        system: Of terms that all have a potential.
        proximal: One of them, with the metric D for a viscosity: of the order of the stiffness.
        tangent: Solves with the tangent of `system`.
        options: Limits of steps.
        directors: Whether an unknown belongs to a director, shape (num_unknowns,).
        lag: Told the state that a step starts from: friction has a potential for normal forces that stay.
    """

    def __init__(
        self,
        system: GlobalSystem,
        proximal: ProximalTerm,
        tangent: FactorisedTangent,
        options: StepOptions,
        directors: np.ndarray,
        lag: Callable[[Floats], None] = lambda q: None,
    ) -> None:
        self.system, self.proximal, self.tangent = system, proximal, tangent
        self.options, self.directors, self.lag = options, directors, lag
        self.symmetric = True
        self.restart(system.q)

    def restart(self, q: Floats) -> None:
        """Begins at a state, as if nothing were known of it."""
        self.q, self.damping, self.norm = q, 1.0, np.inf

    def residual(self, q: Floats | None = None) -> float:
        """Relative residual at the current unknowns, or at others, which become the current ones."""
        self.q = self.q if q is None else q
        self._set_state(self.q)
        self._forces = self.system.constraints.reduce(self.system.residual())
        self.norm = float(np.linalg.norm(self._forces))
        return self.norm / max(self.system.force_scale, self.options.least_force, 1e-300)

    def step(self) -> bool:
        """Solves for a step from where `residual` was asked for last, and takes what lowers the potential.

        Returns:
            Whether anything of it did; if not, the damping parameter is raised.
        """
        system, free = self.system, self.system.free_values(self.q)
        self._set_state(self.q)
        self.lag(self.q)
        energy = system.energy()
        direction = self._direction()
        slope = 0.0 if direction is None else float(self._forces @ direction)
        part = 1.0
        for _ in range(HALVINGS if slope < 0.0 else 0):
            assert direction is not None
            q = system.expand(free + part * direction)
            self._set_state(q)
            allowed = SUFFICIENT * part * slope + ROUND_OFF * abs(energy)
            if system.energy() <= energy + allowed:
                self.q = q
                return True
            part /= 2.0
        self.damping = min(STRONGER * self.damping, MOST)
        return False

    def adapt(self, before: float, near: bool = False) -> None:
        """Lets the damping parameter follow the residual, whose norm was `before` the last step.

        Near an equilibrium, where it falls, the parameter falls by a factor of ten at least: beside soft modes, as of a
        long yarn to its side, the residual would fall as slowly as the parameter does.
        """
        ratio = self.norm / max(before, 1e-300)
        ratio = min(ratio, NEARER) if near and ratio < 1.0 else ratio
        self.damping = float(np.clip(self.damping * ratio, LEAST, MOST))

    def _set_state(self, q: Floats) -> None:
        self.proximal.start = self.proximal.anchor = q  # there it has neither force nor energy
        self.system.set_state(q)

    def _direction(self) -> Floats | None:
        """The step within its limits; None where there is none."""
        system = self.system
        system.update_pattern()
        system.set_step(np.zeros_like(self.q))
        with self.proximal.scaled(self.damping):
            system.assemble_tangent()
        step = self.tangent.solve(-self._forces, self.symmetric)
        if step is None or not np.all(np.isfinite(step)):
            return None
        turning = self.directors[system.constraints.free]
        longest = np.abs(step[~turning]).max(initial=0.0) / self.options.max_step
        widest = np.abs(step[turning]).max(initial=0.0) / self.options.max_turn
        return step / max(longest, widest, 1.0)
