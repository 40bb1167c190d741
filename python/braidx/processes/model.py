"""The rope as a system to solve: one body, its contact, its ends, its Newton iteration."""

from __future__ import annotations

import numpy as np
from mpi4py import MPI

from ..bodies import BeamBody, CableBody
from ..geometry import Rope, one_for_all
from ..output.snapshot import Snapshot
from ..scene import Scene
from ..solver.continuation import Continuation
from ..solver.increment import Incrementer
from ..solver.linear import FactorisedTangent
from ..solver.newton import Newton
from ..solver.pseudo_transient import PseudoTransient
from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from ..system.proximal import ProximalTerm
from ..system.terms import BodyTerm, LoadTerm, Term
from .ends import Ends
from .grouped_ends import GroupedEnds
from .measurements import state_results
from .newton_options import UNSTRETCHED, newton_options, step_options
from .rope_contact import elements_beyond, make_contact
from .rope_picture import rope_picture
from .state import State
from .yarns import cable_turning, section_tilt, yarn_material


SOLVES = 4  # times solver.max_iterations steps before an increment is cut


class RopeModel:
    """A rope of one kind of body, ready to be solved increment by increment.

    Attributes:
        body: The yarns.
        contact: Contact between them.
        ends: The two end sections.
        system: Global system of body, contact, loads and stabilisation.
        incrementer: Solves one increment of forming, with Newton's method.
        continuation: Solves one increment of the formed rope.
        preload_energy: Elastic energy of the reference state, mJ.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        scene: Scene,
        rope: Rope,
        body: CableBody | BeamBody,
        ends: Ends | GroupedEnds,
    ) -> None:
        self.comm, self.scene, self.rope, self.body = comm, scene, rope, body
        self.preload_energy = 0.0
        size = body.num_unknowns
        held = ends.held(0.0)
        is_image = held[0].copies[ends.nodes.first] == 0.0
        beyond = elements_beyond(rope, body) if ends.periodic else 0
        self.contact = make_contact(comm, scene, rope, body, is_image, beyond)
        self.proximal = ProximalTerm(size, comm.rank, cable_turning(body))
        self.loads = LoadTerm(size, comm.rank)
        self.directors = np.tile(np.arange(body.block) >= 3, body.num_nodes)
        self.ends = ends
        self.tilt = section_tilt(comm, scene, body)
        terms: list[Term] = [BodyTerm(body, 0), self.contact, self.proximal, self.loads]
        terms += [self.tilt] if self.tilt else []
        self.system = GlobalSystem(comm, terms, *held)
        self.newton = Newton(self.system, newton_options(scene), self.directors)
        self.incrementer = Incrementer(self.newton, self.contact, self.proximal)
        steps = PseudoTransient(
            self.system,
            self.proximal,
            FactorisedTangent(self.system, scene.solver.petsc),
            step_options(scene),
            self.directors,
            self.contact.lag,
        )
        most = SOLVES * scene.solver.max_iterations
        self.continuation = Continuation(steps, self.contact, scene.solver.tolerance, most)

    @property
    def start(self) -> Floats:
        """Unknowns of the reference state, shape (num_unknowns,)."""
        return self.body.rest.ravel().copy()

    def set_reference(self, q: Floats) -> None:
        """Makes a state the one that strains are measured from, shape (num_unknowns,)."""
        rows = q.reshape(-1, self.body.block)
        self.body.set_reference(rows)
        if self.tilt:
            self.tilt.set_reference(rows)

    def set_yarns(self, tension: float, axial_stiffness: float) -> None:
        """Tension in the reference state, and axial stiffness (N) of all yarns."""
        if isinstance(self.body, CableBody):
            self.body.set_properties(tension=tension, axial_stiffness=axial_stiffness)
        else:
            material = yarn_material(self.scene, axial_stiffness)
            self.body.set_properties(tension=tension, material=material)

    def set_viscosity(self, positions: float, directors: float = 0.0) -> None:
        """Stabilisation: N/mm per node on positions, N mm per radian on directors, or tangents of cables."""
        self.proximal.set_viscosity(self.directors, positions, directors)

    def measure(self, tension: float) -> None:
        """Gives steps of the continuation their metric: what yarns of a mean tension (N) resist across."""
        length = float(self.body.rest_lengths().mean()) / self.body.layout.degree
        tension = max(tension, UNSTRETCHED * self.scene.yarn.axial_stiffness)
        self.set_viscosity(tension / length, tension * length)

    @property
    def parallel_stiffness(self) -> float:
        """Axial stiffness of as many yarns side by side, N."""
        return self.rope.num_yarns * self.scene.yarn.axial_stiffness

    def pull_by(self, force: float) -> None:
        """Loads the sample with a force on its last section (N), the same on all yarns; nothing else loads it."""
        self.loads.loads[:] = 0.0
        # On the sample, not on its first section, where that moves along.
        self.loads.loads[self.ends.nodes.last_axial] = force / self.rope.num_yarns
        self.loads.loads[self.ends.nodes.first + 2] = -force / self.rope.num_yarns

    @property
    def copies(self) -> int:
        """How often what is solved for occurs in the sample."""
        return self.scene.rope.pitches if one_for_all(self.scene) else 1

    def picture(self, state: State, name: str) -> Snapshot:
        """See RecordedModel."""
        return rope_picture(self, state, name)

    def results(self, state: State, picture: Snapshot) -> dict[str, float]:
        """See RecordedModel."""
        wrong = self.copies * self.wrong_side_crossings(state.q)
        return state_results(picture, wrong, state.forms)

    def wrong_side_crossings(self, q: Floats) -> int:
        """Number of yarn crossings, seen along the radial direction, where the wrong yarn is outside."""
        # Those near an end of a periodic sample come once more, last.
        heights = self.contact.crossing_heights(q)[: self.rope.num_yarn_crossings]
        return int(np.sum(heights < 0))

    def positions(self, q: Floats) -> Floats:
        """Node positions, shape (num_nodes, 3), mm."""
        return q.reshape(-1, self.body.block)[:, :3]

    def centre_lines(self, q: Floats) -> tuple[Floats, ...]:
        """Node positions of each yarn, shape (num_nodes_i, 3), mm."""
        return tuple(np.split(self.positions(q), self.body.curves[1:-1]))

    def tension(self, q: Floats) -> Floats:
        """Axial force of all elements, shape (num_elements,), N."""
        return self.body.tension(q.reshape(-1, self.body.block))

    def internal_energy(self, q: Floats) -> float:
        """Elastic energy of the yarns of all processes, mJ, that of the reference state's tension included."""
        self.system.set_state(q)
        energy = self.body.energy() + (self.tilt.energy() if self.tilt else 0.0)
        return float(self.comm.allreduce(energy)) + self.preload_energy

    def axial_force(self, q: Floats) -> float:
        """Force that the far end section is pulled with, N, in a state of equilibrium."""
        return float(self._from_outside(q)[self.ends.nodes.last_axial].sum())

    def axial_moment(self, q: Floats) -> float:
        """Moment about the axis that the far end section is turned with, N mm, in a state of equilibrium."""
        # Positions, and directors of beams: forces on these are couples on sections.
        vectors = self.ends.nodes.last[:, None, None] + np.arange(self.body.block).reshape(-1, 3)
        return float(np.cross(q[vectors], self._from_outside(q)[vectors])[..., 2].sum())

    def _from_outside(self, q: Floats) -> Floats:
        """Reactions and loads, shape (num_unknowns,), N; those on images are with the yarns that lead them."""
        self.system.set_state(q)
        return self.system.constraints.copies * (self.system.residual() + self.loads.loads)
