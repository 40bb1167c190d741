"""Scenes of a few rods, put together as a user of the package would do it in Python."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from braidx.bodies import CableBody, CurveBody
from braidx.contact.contact import Contact
from braidx.contact.tubes import TubeLayout
from braidx.solver.increment import Increment, Incrementer, IncrementOptions
from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.proximal import ProximalTerm
from braidx.system.terms import BodyTerm, LoadTerm

Floats = npt.NDArray[np.float64]


class Rods:
    """Rods of one body, in contact with each other and with rigid surfaces.

    Args:
        body: The rods.
        radius: Of their tubes, one value or one per rod, mm.
        penalty: Per length of contact line, N/mm per mm.
        friction: Coefficient of friction.
        spacing: Of contact stations, mm; half the shortest element by default.
        rigid: Rigid surfaces (engine objects).
        tolerance: Relative residual of an equilibrium, and of its contact elements made anew.
        max_step: Largest change of a position in an iteration, mm; the smallest radius by default.

    Attributes:
        q: Unknowns now, shape (num_nodes, block).
        loads: Dead loads, shape (num_nodes, block), N.
        held: Values of held unknowns, shape (num_nodes, block).
        viscosity: Of the stabilisation, shape (num_nodes, block), N/mm; none at first.
    """

    def __init__(
        self,
        body: CurveBody,
        radius: npt.ArrayLike,
        *,
        penalty: float,
        friction: float = 0.0,
        spacing: float | None = None,
        rigid: Sequence[Any] = (),
        tolerance: float = 1e-9,
        max_step: float | None = None,
        symmetric: bool = True,
    ) -> None:
        self.body, self.q = body, np.array(body.rest)
        tubes = tube_layout(body, radius)
        self.contact = Contact(MPI.COMM_SELF, tubes, smooth=True, symmetric=symmetric)
        self.contact.rigid = list(rigid)
        self.contact.pairing.stiffness = penalty
        self.contact.pairing.spacing = spacing or tubes.element_length.min() / 2
        self.contact.pairing.search.margin = tubes.radius.min() / 2
        self.contact.laws.friction = [friction]
        self.contact.laws.regularisation = 1e-4 * tubes.radius.min()
        self.contact.laws.reversible_slip = 1e-3 * tubes.radius.min()
        self._load_term = LoadTerm(body.num_unknowns)
        self._proximal = ProximalTerm(body.num_unknowns)
        self.loads = self._load_term.loads.reshape(self.q.shape)
        self.viscosity = self._proximal.viscosity.reshape(self.q.shape)
        self.held = np.array(self.q)
        self._fixed = np.zeros(self.q.shape, dtype=bool)
        self._newton = NewtonOptions(
            tolerance, max_step=max_step or tubes.radius.min(), symmetric=symmetric
        )
        self._options = IncrementOptions(pairing_tolerance=10 * tolerance, max_updates=40)

    def nodes(self, rod: int) -> slice:
        """Nodes of a rod."""
        return slice(*self.body.curves[rod : rod + 2])

    def hold(self, nodes: Any, components: Any = slice(None)) -> None:
        """Unknowns that take their values from `held`."""
        self._fixed[nodes, components] = True

    def solve(self, guess: Floats | None = None) -> Increment:
        """Equilibrium with the held values and loads as they are now; the increment begins at `q`."""
        constraints = Constraints(self.q.size)
        constraints.hold(np.flatnonzero(self._fixed))
        values = np.where(self._fixed, self.held, 0.0).ravel()
        terms = [BodyTerm(self.body, 0), self.contact, self._proximal, self._load_term]
        self.system = GlobalSystem(MPI.COMM_SELF, terms, constraints.resolve(), values)
        directors = np.tile(np.arange(self.body.block) >= 3, self.body.num_nodes)
        newton = Newton(self.system, self._newton, directors)
        incrementer = Incrementer(newton, self.contact, self._proximal)
        first = self.system.expand(
            self.system.free_values((self.q if guess is None else guess).ravel())
        )
        increment = incrementer.solve(self.q.ravel(), first, self._options)
        self.q = increment.q.reshape(self.q.shape)
        return increment

    def reactions(self) -> Floats:
        """Forces that hold the held unknowns, shape (num_nodes, block), N; zero elsewhere."""
        self.system.set_state(self.q.ravel())
        return self.system.residual().reshape(self.q.shape)

    def contacts(self) -> dict[str, npt.NDArray[Any]]:
        """Results per contact element, see Contact.results."""
        return self.contact.results(self.q.ravel())


def tube_layout(body: CurveBody, radius: npt.ArrayLike) -> TubeLayout:
    """Tubes around the curves of a body whose unknowns come first."""
    curves, elements = body.curves, body.layout.curve_elements
    ones = np.ones(len(curves) - 1, dtype=np.int64)
    length = np.add.reduceat(body.rest_lengths(), elements[:-1]) / np.diff(elements)
    return TubeLayout(
        first_unknown=curves[:-1] * body.block,
        num_elements=np.diff(elements),
        degree=ones * body.layout.degree,
        block=ones * body.block,
        radius=radius * np.ones(len(ones)),
        element_length=length,
        body=0 * ones,
    )


def cables(
    lines: Sequence[Floats], axial_stiffness: npt.ArrayLike, tension: float = 0.0, degree: int = 1
) -> CableBody:
    """Cables along the given lines."""
    return CableBody(
        MPI.COMM_SELF, lines, axial_stiffness=axial_stiffness, tension=tension, degree=degree
    )


def straight(start: Sequence[float], end: Sequence[float], num_elements: int) -> Floats:
    """Nodes of a straight line, shape (num_elements + 1, 3), mm."""
    return np.linspace(start, end, num_elements + 1)


def helix(
    radius: float, pitch: float, length: float, num_elements: int, phase: float = 0.0
) -> Floats:
    """Nodes of a helix about the z axis, from z = 0 to `length`, shape (num_elements + 1, 3), mm."""
    z = np.linspace(0.0, length, num_elements + 1)
    angle = phase + 2.0 * np.pi * z / pitch
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
