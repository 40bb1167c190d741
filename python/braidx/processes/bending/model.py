"""The bent rope as a system to solve."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from mpi4py import MPI

from ...bodies.tilt import SectionTilt
from ...output.snapshot import Snapshot
from ...scene import Scene
from ...solver.increment import Incrementer
from ...solver.newton import Newton
from ...system.constraints import Floats
from ...system.global_system import GlobalSystem
from ...system.proximal import ProximalTerm
from ...system.terms import BodyTerm, LoadTerm, Term
from ..newton_options import newton_options
from ..state import State
from ..yarns import cable_turning
from .assembly import Assembly
from .clamp import SIZE, ClampTerm
from .contact import make_contact
from .curves import shear_stiffness
from .ends import Ends
from .joints import joints
from .picture import bent_picture
from .results import bent_results
from .sheave import SheavePlace
from .stretches import Stretch
from .surfaces import surfaces_of


# METIS orders these matrices as well as any other, in half of the time that MUMPS takes to choose.
ORDERING = {"mat_mumps_icntl_7": 5}

LEAST_STRAIN = 1e-5  # of one yarn: smaller forces are none, as in the straight rope


class BentRope:
    """Yarns, core and clamps, with contact among them and with the sheave.

    Attributes:
        assembly: The bodies.
        surfaces: What may touch.
        contact: Contact between them.
        sheave: Where the sheave is.
        system: Global system of bodies, clamps, contact, loads and stabilisation.
        incrementer: Solves one increment.

    Args:
        comm, scene: As of the run.
        lines: Centre lines of the straight rope, shape (num_nodes, 3) each, mm.
        stretches: What yarns are modelled as.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        scene: Scene,
        lines: Sequence[Floats],
        stretches: Sequence[Stretch],
    ) -> None:
        self.comm, self.scene, self.lines = comm, scene, tuple(lines)
        self.assembly = Assembly(comm, scene, lines, stretches)
        self.start = self.assembly.start
        self.sheave = SheavePlace.below(scene, lines)
        self.surfaces = surfaces_of(self.assembly)
        self.contact = make_contact(comm, scene, self.surfaces, self.start)
        self.contact.rigid = [self.sheave.surface(self.assembly.sheave)]
        size = len(self.start)
        cables = self.assembly.cables
        self.proximal = ProximalTerm(size, comm.rank, cable_turning(*cables) if cables else None)
        self.loads = LoadTerm(size, comm.rank)
        yarn, radius = scene.yarn, scene.yarn.radius
        turning = [clamp.vector(2) for clamp in self.assembly.clamps]
        turning += [self.assembly.sheave.vector(2)] if self.assembly.sheave.turns_freely else []
        self.clamp_term = ClampTerm(turning, yarn.axial_stiffness * radius, mine=comm.rank == 0)
        self.tilt = self._tilt()
        terms: list[Term] = [BodyTerm(body, first) for body, first in self.assembly.bodies]
        terms += [self.contact, self.proximal, self.loads, self.clamp_term]
        terms += [self.tilt] if self.tilt else []
        constraints, self._values = joints(self.assembly)
        self.system = GlobalSystem(comm, terms, constraints.resolve(), self._values)
        self.directors = self._directors()
        options = replace(
            newton_options(scene),
            least_force=LEAST_STRAIN * yarn.axial_stiffness,
            petsc={**ORDERING, **scene.solver.petsc},
            lagged=True,
        )
        self.newton = Newton(self.system, options, self.directors)
        # Of a yarn that bends over a pitch: without tension nothing else holds it until it touches others.
        bending = 0.25 * yarn.axial_stiffness * radius**2 * yarn.bundle_factor
        loose = bending / scene.rope.pitch**3
        self.incrementer = Incrementer(self.newton, self.contact, self.proximal, loose)

    def move(self, ends: Ends, angle: float) -> None:
        """Prescribes where the ends are, and how far a sheave that is not free has turned.

        Args:
            ends: What is asked for.
            angle: Of the sheave, radians.
        """
        values = self._values.copy()
        first, last = self.assembly.clamps
        rise = ends.run * math.sin(ends.slope)
        values[first.travel], values[last.travel] = rise - ends.travel, -rise - ends.travel
        values[first.axial] += 2.0 * ends.run * math.cos(ends.slope)
        for clamp, sign in ((first, -1.0), (last, 1.0)):
            self.loads.loads[clamp.axial] = sign * ends.pull
        self.assembly.sheave.turn_to(values, angle)
        self.system.constraint_values = values

    def slope(self, q: Floats) -> float:
        """Angle that the rope rises by at its first end, and falls by at its last one, the mean of both, radians."""
        first, last = self.assembly.clamps
        return 0.5 * (first.slope(q) - last.slope(q))

    def strain(self, q: Floats) -> float:
        """Of the straight rope."""
        first, last = self.assembly.clamps
        return float((q[last.axial] - q[first.axial]) / self.scene.length - 1.0)

    def set_viscosity(self, positions: float, directors: float) -> None:
        """Stabilisation: N/mm per node on positions, N mm per radian on directors, or tangents of cables."""
        self.proximal.set_viscosity(self.directors, positions, directors)

    def internal_energy(self, q: Floats) -> float:
        """Elastic energy of yarns and core of all processes, mJ."""
        self.system.set_state(q)
        energy = sum(body.energy() for body, _ in self.assembly.bodies) + self.clamp_term.energy()
        energy += self.tilt.energy() if self.tilt else 0.0
        return float(self.comm.allreduce(energy))

    def end_forces(self, q: Floats) -> Floats:
        """Force that each end is moved towards the sheave with, shape (2,), N, in a state of equilibrium."""
        self.system.set_state(q)
        outside = self.system.residual()
        closure = self.system.constraints.closure
        travels = [clamp.travel for clamp in self.assembly.clamps]
        return np.asarray(-(closure[:, travels].T @ outside)).ravel()

    @property
    def copies(self) -> int:
        """How often what is solved for occurs in the sample: once."""
        return 1

    def picture(self, state: State, name: str) -> Snapshot:
        """See RecordedModel."""
        return bent_picture(self, state, name)

    def results(self, state: State, picture: Snapshot) -> dict[str, float]:
        """See RecordedModel."""
        return bent_results(self, state, picture)

    def _directors(self) -> np.ndarray:
        """Whether an unknown belongs to a director, shape (num_unknowns,)."""
        out = np.zeros(len(self.start), dtype=bool)
        for body, first in self.assembly.bodies:
            out[first : first + body.num_unknowns] = np.arange(body.num_unknowns) % body.block >= 3
        for clamp in self.assembly.clamps:
            out[clamp.first_unknown + 3 : clamp.first_unknown + SIZE] = True
        out[self.assembly.sheave.first_unknown + 3 :] = True
        return out

    def _tilt(self) -> SectionTilt | None:
        if self.assembly.beams is None:
            return None
        body, first = self.assembly.beams
        stiffness = shear_stiffness(body, self.scene, self.assembly.core_is_beam)
        return SectionTilt(body.layout, body.rest, stiffness, self.comm.rank == 0, first)
