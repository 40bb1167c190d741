"""The rope as a system to solve: one body, its contact, its ends, its Newton iteration."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import braidx_engine as engine
import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..bodies import BeamBody, BeamSection, CableBody, CurveBody, YarnMaterial
from ..bodies.tilt import SHARE, SectionTilt
from ..contact.contact import Contact
from ..contact.tubes import TubeLayout
from ..geometry import Crossings, Rope
from ..scene import Scene
from ..solver.increment import Incrementer
from ..solver.newton import Newton, NewtonOptions
from ..system.constraints import Floats
from ..system.global_system import GlobalSystem
from ..system.proximal import ProximalTerm
from ..system.terms import BodyTerm, LoadTerm, Term
from ..system.turning import Turning
from .ends import Ends
from .grouped_ends import GroupedEnds
from .threads import num_threads

WINDOW = 0.1  # of a pitch: how far to either side of its crossing a yarn is held to its side


class RopeModel:
    """A rope of one kind of body, ready to be solved increment by increment.

    Attributes:
        body: The yarns.
        contact: Contact between them.
        ends: The two end sections.
        system: Global system of body, contact, loads and stabilisation.
        incrementer: Solves one increment.
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
        solver = scene.solver
        options = NewtonOptions(
            tolerance=solver.tolerance,
            max_iterations=solver.max_iterations,
            max_step=rope.radius.min(),
            max_turn=solver.director_cap,
            symmetric=solver.tangent == "symmetric",
            petsc=solver.petsc,
        )
        self.newton = Newton(self.system, options, self.directors)
        self.incrementer = Incrementer(self.newton, self.contact, self.proximal)

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
        self.proximal.viscosity[:] = np.where(self.directors, directors, positions)
        if self.proximal.turning:
            self.proximal.turning.viscosity = directors

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


def cable_body(
    comm: MPI.Comm,
    scene: Scene,
    lines: Sequence[Floats],
    axial_stiffness: float,
    tension: Floats | float,
) -> CableBody:
    """Yarns as cables along the given centre lines."""
    return CableBody(
        comm,
        lines,
        axial_stiffness=axial_stiffness,
        tension=tension,
        degree=scene.yarn.degree,
        area=scene.yarn.section_area,
    )


def beam_body(
    comm: MPI.Comm, scene: Scene, lines: Sequence[Floats], tension: Floats | float
) -> BeamBody:
    """Yarns as beams, under tension but unbent as placed (or straight).

    Args:
        comm: Communicator.
        scene: The scene.
        lines: Positions and directors of each yarn's nodes, shape (num_nodes_i, 9).
        tension: Axial force as placed, N.
    """
    yarn = scene.yarn
    circle = BeamSection.round(yarn.radius)
    inertia_1 = yarn.inertia_1 or circle.inertia_1
    inertia_2 = yarn.inertia_2 or circle.inertia_2
    section = BeamSection(
        yarn.section_area,
        inertia_1,
        inertia_2,
        yarn.torsion_constant or inertia_1 + inertia_2,
        yarn.section_area * (1.0 - SHARE if yarn.degree == 1 else 1.0),
    )
    return BeamBody(
        comm,
        [line[:, :3] for line in lines],
        section=section,
        material=yarn_material(scene),
        directors=[line[:, 3:].reshape(-1, 2, 3) for line in lines],
        degree=yarn.degree,
        bundle_factor=yarn.bundle_factor,
        torsion_factor=yarn.torsion_factor,
        natural_state="straight" if yarn.natural_state == "straight" else "as placed",
        tension=tension,
    )


def yarn_material(scene: Scene, axial_stiffness: float | None = None) -> YarnMaterial:
    """Material of beams; with an axial stiffness (N) other than the yarn's there is no lateral contraction."""
    yarn = scene.yarn
    real = axial_stiffness is None or axial_stiffness == yarn.axial_stiffness
    return YarnMaterial(
        (axial_stiffness or yarn.axial_stiffness) / yarn.section_area,
        yarn.transverse_modulus,
        yarn.shear_modulus,
        yarn.poisson_axial if real else 0.0,
        yarn.poisson_transverse,
    )


def cable_turning(body: CurveBody) -> Turning | None:
    """Stabilisation of the tangents of cables."""
    if body.block != 3:
        return None
    nodes = np.setdiff1d(np.arange(body.num_nodes - 1), body.layout.curves[1:-1] - 1)
    length = np.repeat(body.rest_lengths() / body.layout.degree, body.layout.degree)
    return Turning(3 * nodes, 3 * nodes + 3, length)


def section_tilt(comm: MPI.Comm, scene: Scene, body: CurveBody) -> SectionTilt | None:
    """The nodes' share of the shear of beams of degree 1."""
    if body.block != 9 or body.layout.degree != 1:
        return None
    shear_stiffness = SHARE * scene.yarn.shear_modulus * scene.yarn.section_area
    return SectionTilt(body.layout, body.rest, shear_stiffness, mine=comm.rank == 0)


def make_contact(
    comm: MPI.Comm,
    scene: Scene,
    rope: Rope,
    body: CurveBody,
    is_image: npt.NDArray[np.bool_],
    beyond: int,
) -> Contact:
    """Contact of all yarns, with laws and spacing from the scene.

    Args:
        comm, scene, rope, body: As of the model.
        is_image: Whether the equilibrium of a yarn repeats another's, shape (num_yarns,).
        beyond: Elements that yarns go on for past their ends.
    """
    curves, options = body.layout.curves, scene.contact
    num_elements = np.diff(body.layout.curve_elements)
    lengths = np.add.reduceat(body.rest_lengths(), body.layout.curve_elements[:-1])
    ones = np.ones(len(num_elements), dtype=np.int64)
    layout = TubeLayout(
        first_unknown=curves[:-1] * body.block,
        num_elements=num_elements,
        degree=ones * body.layout.degree,
        block=ones * body.block,
        radius=rope.radius,
        element_length=lengths / num_elements,
        body=0 * ones,
        beyond=beyond,
        is_image=is_image,
    )
    crossings = engine_crossings(rope, lengths, beyond / num_elements[0])
    contact = Contact(
        comm,
        layout,
        crossings,
        smooth=True,
        symmetric=scene.solver.tangent == "symmetric",
        num_threads=num_threads(comm),
    )
    radius = rope.radius.min()
    contact.pairing.spacing = (
        options.station_spacing * float(layout.element_length.min()) / body.layout.degree
    )
    contact.pairing.stiffness = options.penalty or 0.01 * scene.yarn.axial_stiffness / radius**2
    contact.pairing.search.margin = options.search_distance * radius
    contact.pairing.crossing.by_point = True
    contact.pairing.point_tolerance = options.penetration_tolerance * radius
    contact.laws.regularisation = options.regularisation * radius
    contact.laws.reversible_slip = options.reversible_slip * radius
    contact.laws.friction = [options.friction]
    return contact


def elements_beyond(rope: Rope, body: CurveBody) -> int:
    """Elements that yarns of a periodic sample go on for past its ends: whole windows of crossings, and one more."""
    per_pitch = np.diff(body.layout.curve_elements).min() * rope.pitch / rope.length
    return math.ceil(WINDOW * per_pitch) + 1


def engine_crossings(rope: Rope, lengths: Floats, beyond: float) -> Any:
    """Crossings of all yarns of crossing strands, with windows in rest arc length (mm).

    A window reaches a tenth of a pitch to either side: crossings of one pair are half a pitch apart. Those whose
    windows reach past an end come last, once more at the other end.

    Args:
        rope: The start configuration.
        lengths: Of the yarns at rest, shape (num_yarns,), mm.
        beyond: What yarns go on for past their ends, over their length.
    """
    yarns = [np.flatnonzero(rope.strand == s) for s in range(rope.num_strands)]
    crossings: Crossings = rope.crossings
    tubes, windows, order = [], [], []
    for period in (0, 1, -1):
        for a, b, z, sign in zip(
            crossings.strand_a, crossings.strand_b, crossings.z, crossings.order, strict=True
        ):
            reach = np.array([-WINDOW, WINDOW]) * rope.pitch
            window = np.clip((z + reach) / rope.length + period, -beyond, 1.0 + beyond)
            if window[0] >= window[1]:
                continue
            for yarn_a in yarns[a]:
                for yarn_b in yarns[b]:
                    tubes.append((yarn_a, yarn_b))
                    windows.append(
                        np.concatenate([window * lengths[yarn_a], window * lengths[yarn_b]])
                    )
                    order.append(sign)
    return engine.make_crossings(
        tubes=np.array(tubes, np.int32).ravel(),
        windows=np.array(windows, float).ravel(),
        order=np.array(order, np.int32),
        axis=np.array([0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    )
