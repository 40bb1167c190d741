"""Balance of energy of rods in motion, step by step, and whether a step made energy."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..contact.contact import Contact
from ..solver.trial import Diverged
from ..system.terms import Floats
from .equilibria import Equilibria
from .inertia import InertiaTerm
from .layout import Layout

EPS = float(np.finfo(float).eps)


class MakesEnergy(Diverged):
    """A step ended with more energy than was put in."""

    sought = "step that keeps energy"
    cures = (
        "shorter steps; `Scheme.generalised_alpha(0.0)` or `Scheme.backward_euler()`, which take energy out of fast "
        "motions; or a smaller `penalty` with `penetration=None`, where rods bounce off each other"
    )


@dataclass(frozen=True)
class MotionStep:
    """An accepted step of motion, with its balance of energy.

    The change of kinetic + elastic + contact energy is the work of supports and loads less friction and numerical
    dissipation, which is found from this balance. Energies are those at the end of the step, works those of the
    step, mJ.

    Attributes:
        share: Of the duration that is done, -.
        time, length: At the end, and from the begin to the end of the step, s.
        kinetic: Of all masses.
        elastic: Stored in the rods.
        contact: Of penalties and of the reversible slip of friction.
        work_of_supports, work_of_loads: Positive into the rods.
        friction_work: Dissipated by friction, at least 0.
        numerical_dissipation: Taken out by the time integration, and by contact elements and penalties that are made
            anew; negative where these put energy in.
    """

    share: float
    time: float
    length: float
    kinetic: float
    elastic: float
    contact: float
    work_of_supports: float
    work_of_loads: float
    friction_work: float
    numerical_dissipation: float

    @property
    def energy(self) -> float:
        """Kinetic, elastic and contact energy at the end of the step, mJ."""
        return self.kinetic + self.elastic + self.contact


@dataclass(frozen=True)
class _State:
    """What the balance needs to know of an instant; shapes (num_unknowns,).

    `driven` is the part of the velocity that supports prescribe; `forces` are those of all terms but inertia. The last
    one of `energies`, that of contact, contains `slip_energy`.
    """

    q: Floats
    velocity: Floats
    driven: Floats
    forces: Floats
    loads: Floats
    friction: Floats
    energies: tuple[float, float, float]
    slip_energy: float


class EnergyBalance:
    """Keeps the balance of a run, and refuses steps that make energy.

    A scheme may give back what it took before, as it does where a wave or a contact is not resolved by its steps.
    What it puts in beyond that makes energy. Allowed is what solver and round-off leave open, and a fraction of the
    energy in motion, of which a step may use half of what is left: the root of the solver's tolerance, halfway in
    decades between this tolerance, which the truncation error of no scheme meets, and one.

    Attributes:
        credit: Numerical dissipation since the rods were at rest last, mJ.
    """

    def __init__(
        self, equilibria: Equilibria, layout: Layout, contact: Contact, credit: float
    ) -> None:
        self._equilibria, self._layout, self._contact = equilibria, layout, contact
        self.credit = credit
        self._exchanged = 0.0
        self._now: _State

    def begin(self, q: Floats, inertia: InertiaTerm) -> None:
        """A run starts from the state q."""
        self._now = self._state(q, inertia)
        self._rest = self._now.energies[1] + self._now.energies[2]

    def close(
        self,
        q: Floats,
        inertia: InertiaTerm,
        friction_work: float,
        share: float,
        time: float,
    ) -> MotionStep:
        """The balance of a step that ends at q, where `inertia` has ended it, too.

        Args:
            friction_work: Dissipated by friction in the step, mJ.
            share: Of the run that is done at the end of the step.
            time: At its end, s.
        Raises:
            MakesEnergy: If it made energy; the balance then stays at the begin of the step.
        """
        before, after = self._now, self._state(q, inertia)
        after = self._with_slip_energy(before, after, friction_work)
        (supports, loads), unsettled = self._works(before, after, inertia.scheme.alpha_f)
        gain = sum(after.energies) - sum(before.energies)
        lost = supports + loads - friction_work - gain
        exchanged = max(
            self._exchanged + abs(supports) + abs(loads),
            after.energies[0] + abs(sum(after.energies[1:]) - self._rest),
        )
        fraction = float(np.sqrt(self._equilibria.tolerance)) * exchanged
        allowed = max(self.credit, 0.0) + 0.5 * max(fraction + min(self.credit, 0.0), 0.0)
        allowed += unsettled + self._tolerance(before, after, inertia)
        if -lost > allowed:
            raise MakesEnergy(
                f"the step of {inertia.step:.3g} s to the time {time:.6g} s made {-lost:.3g} mJ out of nothing, "
                f"beside {exchanged:.3g} mJ in motion",
                0,
                0,
            )
        self.credit += lost
        self._now, self._exchanged = after, exchanged
        return MotionStep(
            share, time, inertia.step, *after.energies, supports, loads, friction_work, lost
        )

    @staticmethod
    def _with_slip_energy(before: _State, after: _State, dissipated: float) -> _State:
        """The end of a step with the energy that reversible slip has taken up, but not dissipated.

        It lies between none and F . slip / 2, which grows and falls with normal forces without any work, too.
        """
        taken = -0.5 * (before.friction + after.friction) @ (after.q - before.q)
        most, stored = after.slip_energy, before.slip_energy + float(taken) - dissipated
        slip = min(max(stored, 0.0), most)
        kinetic, elastic, contact = after.energies
        return replace(after, energies=(kinetic, elastic, contact - most + slip), slip_energy=slip)

    def _works(self, before: _State, after: _State, alpha_f: float) -> tuple[Floats, float]:
        """Of supports and loads, by the trapezoidal rule, shape (2,), and what is unsettled, mJ.

        Supports do work on the rods that they hold, and on the masses that move as they do. Where forces change in a
        step, their work is that of the new ones, of the old ones or between, as the way comes first or the change; of
        friction what is dissipated is that of the new ones, of which a scheme may apply a part only.
        """
        moved = after.q - before.q
        driven = moved - self._equilibria.free_part(moved)
        new = np.array([after.forces @ driven, after.loads @ moved])
        old = np.array([before.forces @ driven, before.loads @ moved])
        works = 0.5 * (new + old)
        faster = self._layout.mass * (after.velocity - before.velocity)
        works[0] += 0.5 * (before.driven + after.driven) @ faster
        unsettled = 0.5 * np.abs(new - old).sum()
        unsettled += alpha_f * abs((after.friction - before.friction) @ moved)
        return works, float(unsettled)

    def _tolerance(self, before: _State, after: _State, inertia: InertiaTerm) -> float:
        """Work that residuals below the solver's tolerance do in the step, and round-off of positions, mJ."""
        equilibria = self._equilibria
        scale = max(
            equilibria.system.force_scale,
            float(np.linalg.norm(self._layout.mass * inertia.acceleration)),
            equilibria.round_off(after.q) / equilibria.tolerance,
        )
        way = float(np.linalg.norm(after.q - before.q))
        return scale * (equilibria.pairing_tolerance * way + EPS * float(np.linalg.norm(after.q)))

    def _state(self, q: Floats, inertia: InertiaTerm) -> _State:
        equilibria, velocity = self._equilibria, inertia.velocity
        loads = equilibria.applied(q)
        comm = equilibria.system.comm
        found = self._contact.results(q)
        slips = 0.5 * np.sum(found["friction_force"] * found["slip"])
        slip = comm.allreduce(float(slips))
        contact = comm.allreduce(float(found["energy"].sum())) + slip
        friction = equilibria.friction(q)
        forces = equilibria.forces(q)  # the bodies are at q after it
        elastic = sum(comm.allreduce(body.energy()) for body in self._layout.bodies)
        kinetic = 0.5 * float(self._layout.mass @ velocity**2)
        driven = velocity - equilibria.free_part(velocity)
        return _State(
            q, velocity, driven, forces, loads, friction, (kinetic, elastic, contact), slip
        )
