"""A scene of rods: what touches, what is held, what pulls, and the equilibria that follow."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from mpi4py import MPI

from ..solver.increment import Increment, IncrementOptions
from ..system.proximal import ProximalTerm
from ..system.terms import Floats
from .apart import push_apart
from .boundary import Boundary
from .contact import make_contact
from .equilibria import Equilibria
from .energy_balance import EnergyBalance, MotionStep
from .inertia import InertiaTerm, Scheme
from .friction import Friction
from .frames import Frame
from .joining import Joining
from .layout import lay_out, with_frame
from .linked import Linked
from .loads import Loads
from .motion import TimeSteps, make_inertia
from .options import PATIENCE, newton_options
from .path import NotConverged, follow
from .placed import placed
from .rigid import RigidSurface, make_rigid
from .rod import Rod
from .start import explained, refuse_idle_groups, take_off
from .state import RodState
from .supports import Supports


class Rods(Boundary, Joining, RodState):
    """Rods in contact with each other, with themselves and with rigid surfaces.

    Rods and their nodes go by number, nodes from the end by negative ones. What is held, pulled or moved between two
    calls of `solve` or `run` is applied in the course of the next one.

    Args:
        rods: Cables, beams and solids, at rest.
        friction: Coefficient of friction of all that touches; see `friction_between` for pairs.
        penalty: Per length of contact, N/mm per mm, to begin with; from the softest rod by default. Per area, where
            solids touch, it is over the smallest radius.
        penetration: Largest penetration over the radius of the thinnest rod, which penalties grow for. None: they stay.
        contact: Whether rods touch each other.
        self_contact: Distance along a cable or beam, in radii, from which on it may touch itself. None: never.
        rigid: Rigid surfaces: Plane, Cylinder, Sheave, or objects of braidx_engine.
        spacing: Of places where contact is looked for, mm; half the shortest element by default, two radii at most.
        tolerance: Relative residual of an equilibrium.
        viscosity: Of a stabilisation of positions, N/mm per node, which lets go of what `solve` finds; slows motion.
        max_step: Largest change of a position in an iteration, mm; the size of the longest rod by default, the smallest
            radius where something may touch.
        patience: Full Newton steps in a row that come no nearer, after which steps are searched for; less pays where
            many contacts open and close by turns, as in strands that are bent.
        comm: Processes that share the work.

    Attributes:
        q: Unknowns now, shape (num_unknowns,).
        layout: Where each rod is among them.
        contact: Contact elements, laws and how they are made, for what has no argument here.
        supports, loads: What holds and what pulls.
        penetration: Largest that is accepted, mm, or None.
        time: Of the last one, s.
        friction_work: Dissipated until now, mJ.
        negative_pivots: Directions in which the state that `solve` found is unstable; a warning tells of them. Not
            counted, and 0, under forces that follow sections, and pressure on rods with free ends.
        motion: Steps of `run` since the last `solve`, with their balances of energy.
    """

    def __init__(
        self,
        rods: Sequence[Rod],
        *,
        friction: float = 0.0,
        penalty: float | None = None,
        penetration: float | None = 0.01,
        contact: bool = True,
        self_contact: float | None = None,
        rigid: Sequence[RigidSurface | Any] = (),
        spacing: float | None = None,
        tolerance: float = 1e-8,
        viscosity: float = 0.0,
        max_step: float | None = None,
        patience: int = PATIENCE,
        comm: MPI.Comm = MPI.COMM_WORLD,
    ) -> None:
        self.comm, self.rods = comm, list(rods)
        self.layout = lay_out(comm, rods)
        self.q = self.layout.rest.copy()
        self.supports = Supports(self.layout.rest, self.layout.dependents)
        self.loads = Loads(self.layout)
        self.contact = make_contact(comm, self.layout, contact, self_contact, spacing)
        self.contact.rigid = make_rigid(rigid, len(self.rods))
        self._friction = Friction(self.contact, len(self.rods), rigid, friction)
        stiffness = penalty or min(rod.stiffness_across for rod in rods)
        self.contact.pairing.stiffness = stiffness
        self.contact.pairing.area_stiffness = stiffness / self.contact.min_radius
        nodes = (self.layout.lengths > 0.0) & ~self.layout.is_director
        self.time = self.friction_work = 0.0
        self.negative_pivots = 0
        self.penetration = None if penetration is None else penetration * self.contact.min_radius
        self._inertia: InertiaTerm | None = None
        self._joined = []
        self.motion: list[MotionStep] = []
        newton = newton_options(self.layout, self.contact, tolerance, max_step, patience)
        options = IncrementOptions(pairing_tolerance=10 * tolerance, penetration=self.penetration)
        self._options = newton, options
        self._assemble(np.where(nodes, viscosity, 0.0))

    def _assemble(self, viscosity: Floats) -> None:
        """One system of all that there is, with a viscosity, shape (num_unknowns,)."""
        self.proximal = ProximalTerm(self.q.size, self.comm.rank)
        self.proximal.viscosity[:] = viscosity
        self._equilibria = Equilibria(
            self.comm,
            self.layout,
            self.contact,
            self.proximal,
            self.supports,
            self.loads,
            *self._options,
        )

    def _prepare(self, inertia: InertiaTerm | None = None) -> None:
        self._equilibria.prepare(inertia)
        refuse_idle_groups(self.layout, self._equilibria.system.constraints)

    def _grow(self, frame: Frame | None, links: Sequence[Linked]) -> None:
        """See Joining."""
        if self._inertia is not None:
            raise ValueError("rods are in motion: join them before `run`, or `solve` in between")
        rest = np.empty(0) if frame is None else frame.rest
        self.supports.grow(rest, links)
        if frame is not None:
            self.layout = with_frame(self.layout, frame)
        self.q = np.append(self.q, rest)
        if self.contact.start.size:
            self.contact.start = np.append(self.contact.start, rest)
        self.loads.grow(self.layout)
        self._assemble(np.append(self.proximal.viscosity, np.zeros(rest.size)))

    # Equilibria

    def solve(
        self,
        increments: int = 1,
        *,
        max_cuts: int = 8,
        guess: Floats | Mapping[int, Floats] | None = None,
        observe: Callable[[float], None] = lambda share: None,
    ) -> list[Increment]:
        """Equilibria on the way to what is asked for, in equal increments unless these have to be cut.

        Args:
            increments: Their number.
            max_cuts: How often an increment may be halved.
            guess: First guess of the state at the end, where one is better than the way so far: all unknowns, shape
                (num_unknowns,), or nodes of some rods by their number, shape (num_nodes, 3), mm, with which sections
                turn as little as they can. The way there may go through other rods.
            observe: Called after each increment with the share of the way that is done.
        Raises:
            ValueError: If a rigid group can turn without moving a node.
            NotConverged: If no equilibrium is found; the state is the last one that was, motions and loads stay there.

        Rods that are in each other at the start are pushed apart first. What nothing balances at the start is taken off
        evenly on the way.
        """
        self._inertia, self.motion = None, []
        self._prepare()
        if self.penetration is not None:
            self.q = push_apart(self._equilibria, self.layout, self.contact, self.q)
        self._start = take_off(self._equilibria, self.layout, self.loads, self.q)
        whole = placed(self.layout, self.q, guess)

        def step(begin: float, end: float, before: Floats) -> Increment:
            first = self.q + before
            if whole is not None:
                first = self.q + (whole - self.q) * (end - begin) / (1.0 - begin)
            given = whole is not None
            return self._equilibria.find(self.q, first, end, blind=not given, leap=given)

        found = self._follow(step, increments, max_cuts, observe)
        self.negative_pivots = self._equilibria.negative_pivots(self.q)
        return found

    def run(
        self,
        duration: float,
        step: float,
        *,
        scheme: Scheme | None = None,
        velocity: Floats | None = None,
        max_cuts: int = 8,
        observe: Callable[[MotionStep], None] = lambda step: None,
    ) -> list[Increment]:
        """Motion through time, implicitly; motions and loads go on evenly and are complete at its end.

        A step that makes energy is repeated with half of its length, as one that finds no state.

        Args:
            duration, step: Seconds.
            scheme: Of the steps, generalised alpha with a spectral radius of 0 by default.
            velocity: At the begin, shape (num_unknowns,), mm/s; that of the end of the last run by default, or none.
            observe: Called after each step with its balance of energy, as it is added to `motion`.
        Raises:
            ValueError: If a rod has no density.
            NotConverged: As in `solve`, or if the shortest steps make energy.
        """
        last = self._inertia
        inertia = make_inertia(self.rods, self.layout.mass, scheme, velocity, last, self.comm.rank)
        self._inertia, self._start = inertia, ""
        self._prepare(inertia)
        credit = sum(step.numerical_dissipation for step in self.motion)
        balance = EnergyBalance(self._equilibria, self.layout, self.contact, credit)
        steps = TimeSteps(self._equilibria, self.contact, inertia, balance, duration)
        steps.begin(self.q, fresh=last is None)

        def move(begin: float, end: float, before: Floats) -> Increment:
            increment = steps.step(self.q, begin, end, self.time)
            self.time = steps.last.time
            self.motion.append(steps.last)
            return increment

        number = max(1, round(duration / step))
        return self._follow(move, number, max_cuts, lambda share: observe(steps.last))

    def _follow(
        self,
        step: Callable[[float, float, Floats], Increment],
        increments: int,
        max_cuts: int,
        observe: Callable[[float], None],
    ) -> list[Increment]:
        done = 0.0

        def accept(increment: Increment, share: float) -> None:
            nonlocal done
            self.q, done = increment.q, share
            self.friction_work += increment.friction_work
            observe(share)

        try:
            return follow(step, self.q, increments, max_cuts, accept)
        except NotConverged as failure:
            raise explained(failure, self._start, self.layout, self.supports) from failure.__cause__
        finally:
            self._equilibria.stop(self.q, done)
            self.supports.finish(done)
            self.loads.finish(done)
