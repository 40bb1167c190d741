"""Scenes of solids, curves and rigid surfaces in contact, put together as a user would do it in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from mpi4py import MPI
from support import Floats

from braidx.bodies import CurveBody, SolidBody
from braidx.contact.contact import Contact
from braidx.contact.skins import SkinLayout
from braidx.contact.tubes import no_tubes
from braidx.rods.surfaces import body_tubes
from braidx.solver.increment import Increment, Incrementer, IncrementOptions
from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.proximal import ProximalTerm
from braidx.system.terms import BodyTerm, LoadTerm


class Assembly:
    """Bodies in contact with each other and with rigid surfaces; a body does not touch itself.

    Args:
        bodies: One curve body at most, as the first, then solids.
        skins: Name of the surface of each solid that may touch, by number of the body.
        tube_radius: Of the curves, mm.
        penalty: Per area, N/mm per mm^2; per length on tubes, N/mm per mm.
        length: Size that lengths of contact are small against, mm: search, steps.
        friction: Coefficient of friction.
        spacing: Of stations on tubes, mm.
        dense: See SkinLayout.
        rigid: Rigid surfaces (engine objects).
        tolerance: Relative residual of an equilibrium.

    Attributes:
        q: Unknowns now, shape (num_unknowns,).
        loads, held, viscosity: Dead loads (N), values of held unknowns and stabilisation (N/mm), shape (num_unknowns,).
    """

    def __init__(
        self,
        bodies: Sequence[CurveBody | SolidBody],
        skins: Mapping[int, str],
        *,
        penalty: float,
        length: float,
        tube_radius: float = 0.0,
        friction: float = 0.0,
        spacing: float = 1.0,
        dense: bool = False,
        rigid: Sequence[Any] = (),
        tolerance: float = 1e-7,
    ) -> None:
        self.bodies = list(bodies)
        self.first = np.cumsum([0] + [body.num_unknowns for body in bodies])
        self.q = np.concatenate([body.rest.ravel() for body in bodies])
        self.contact = Contact(
            MPI.COMM_SELF,
            body_tubes(bodies[0], tube_radius) if tube_radius > 0.0 else no_tubes(),
            smooth=True,
            symmetric=False,
            skins=self._skins(skins, length, dense),
            rest=self.q,
        )
        self.contact.rigid = list(rigid)
        self.contact.pairing.area_stiffness = self.contact.pairing.stiffness = penalty
        self.contact.pairing.spacing, self.contact.pairing.search.margin = spacing, 0.5 * length
        self.contact.laws.friction = [friction]
        self.contact.laws.regularisation = 1e-4 * length
        self.contact.laws.reversible_slip = 1e-3 * length
        self._load_term = LoadTerm(self.q.size)
        self._proximal = ProximalTerm(self.q.size)
        self.loads, self.viscosity = self._load_term.loads, self._proximal.viscosity
        self.held = self.q.copy()
        self._fixed = np.zeros(self.q.size, dtype=bool)
        self._ties: list[tuple[npt.NDArray[np.int64], int]] = []
        self._newton = NewtonOptions(tolerance, max_step=length, symmetric=friction == 0.0)
        self._options = IncrementOptions(pairing_tolerance=10 * tolerance)

    def _skins(self, skins: Mapping[int, str], length: float, dense: bool) -> SkinLayout:
        facets = tuple(
            self.first[number] + 3 * self.bodies[number].facet_nodes(tag)
            for number, tag in skins.items()
        )
        ones = np.ones(len(facets), dtype=np.int64)
        return SkinLayout(facets, 0 * ones, -ones, length * ones, dense=dense)

    def of(self, body: int, values: Floats | None = None) -> Floats:
        """A body's part of all unknowns (or of `values`), shape (num_nodes, block): a view."""
        part = (self.q if values is None else values)[self.first[body] : self.first[body + 1]]
        return part.reshape(-1, self.bodies[body].block)

    def unknowns(self, body: int, nodes: npt.ArrayLike, components: Any = slice(None)) -> Any:
        """Numbers of the unknowns of nodes of a body."""
        block = self.bodies[body].block
        return (self.first[body] + block * np.asarray(nodes)[:, None] + np.arange(block))[
            :, components
        ].ravel()

    def hold(self, body: int, nodes: npt.ArrayLike, components: Any = slice(None)) -> None:
        """Unknowns that take their values from `held`."""
        self._fixed[self.unknowns(body, nodes, components)] = True

    def tie(self, body: int, nodes: npt.ArrayLike, component: int) -> int:
        """Nodes that keep their distances along an axis; the unknown that all of them follow."""
        leader, *followers = self.unknowns(body, nodes, [component])
        self._ties.append((np.array(followers), leader))
        return int(leader)

    def solve(self, guess: Floats | None = None) -> Increment:
        """Equilibrium with held values and loads as they are now, from the state `q`; it is also the first guess."""
        constraints = Constraints(self.q.size)
        constraints.hold(np.flatnonzero(self._fixed))
        values = np.where(self._fixed, self.held, 0.0)
        for followers, leader in self._ties:
            constraints.tie(followers, leader)
            values[followers] = self.held[followers] - self.held[leader]
        terms = [BodyTerm(body, first) for body, first in zip(self.bodies, self.first)]
        terms += [self.contact, self._proximal, self._load_term]
        self.system = GlobalSystem(MPI.COMM_SELF, terms, constraints.resolve(), values)
        blocks = [np.tile(np.arange(b.block) >= 3, b.num_nodes) for b in self.bodies]
        newton = Newton(self.system, self._newton, np.concatenate(blocks))
        first = self.system.expand(self.system.free_values(self.q if guess is None else guess))
        increment = Incrementer(newton, self.contact, self._proximal).solve(
            self.q, first, self._options
        )
        self.q = increment.q
        return increment

    def reactions(self) -> Floats:
        """Forces that hold the held unknowns, shape (num_unknowns,), N; zero elsewhere."""
        self.system.set_state(self.q)
        return self.system.residual()

    def contacts(self) -> dict[str, npt.NDArray[Any]]:
        """Results per contact element, see Contact.results."""
        return self.contact.results(self.q)
