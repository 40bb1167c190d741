"""What can be asked of a scene of rods as it is now."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..bodies import SolidBody
from ..contact.contact import Contact
from ..system.terms import Floats
from .equilibria import Equilibria
from .inertia import InertiaTerm
from .layout import Layout
from .picture import draw_rods

ALL = slice(None)


class RodState:
    """State of rods: positions, forces, energies. See Rods."""

    comm: MPI.Comm
    q: Floats
    layout: Layout
    contact: Contact
    _equilibria: Equilibria
    _inertia: InertiaTerm | None

    def positions(self, rod: int) -> Floats:
        """Of its nodes, shape (num_nodes, 3), mm."""
        return self.q[self.layout.unknowns(rod, ALL)[:, :3]]

    def directors(self, rod: int) -> Floats:
        """g1 and g2 of its nodes, shape (num_nodes, 2, 3); of a cable shape (num_nodes, 0, 3)."""
        unknowns = self.layout.unknowns(rod, ALL)
        return np.asarray(self.q[unknowns[:, 3:]].reshape(len(unknowns), -1, 3))

    def tension(self, rod: int) -> Floats:
        """Mean axial force of each element, N, shape (num_elements,)."""
        number, part = (int(value) for value in self.layout.place[rod])
        body, first = self.layout.bodies[number], self.layout.first_body[number]
        state = self.q[first : first + body.num_unknowns].reshape(-1, body.block)
        if isinstance(body, SolidBody):
            return body.mean_axial_force(state, part)
        elements = slice(*body.layout.curve_elements[[part, part + 1]])
        return body.tension(state)[elements]

    def reaction(self, rod: int, node: int) -> tuple[Floats, Floats]:
        """Force (N) and moment about the node (N mm) that hold a node, shape (3,) each."""
        force, moment = self.reactions(rod, node)
        return force[0], moment[0]

    def resultant(
        self, places: Sequence[tuple[int, int]], about: npt.ArrayLike
    ) -> tuple[Floats, Floats]:
        """Force (N) and moment about a point (N mm) that hold nodes, given as (rod, node), shape (3,) each."""
        unknowns = [self.layout.unknowns(rod, node)[0] for rod, node in places]
        holding, centre = self._reactions(), np.asarray(about, dtype=float)
        force, moment = np.zeros(3), np.zeros(3)
        for own in unknowns:
            arms, parts = (values[own].reshape(-1, 3) for values in (self.q, holding))
            force += parts[0]
            moment += np.cross(arms[0] - centre, parts[0])
            moment += np.cross(arms[1:], parts[1:]).sum(axis=0)
        return force, moment

    def reactions(
        self, rod: int, nodes: int | slice | Sequence[int] = ALL
    ) -> tuple[Floats, Floats]:
        """Forces (N) and moments about each node (N mm) that hold nodes, shape (n, 3) each; 0 where they are free.

        Of rods in motion, with what the acceleration of the node takes. A cable has no moments.
        """
        unknowns = self.layout.unknowns(rod, nodes)
        parts = (x[unknowns].reshape(len(unknowns), -1, 3) for x in (self._reactions(), self.q))
        forces, state = parts
        return forces[:, 0], np.cross(state[:, 1:], forces[:, 1:]).sum(axis=1)

    def residual(self) -> Floats:
        """Forces that nothing balances, shape (num_unknowns,), N and, of directors, N mm: 0 in equilibrium.

        Internal forces, contact and inertia less loads and what holds; a stabilisation is none of them.
        """
        return self._unbalanced()[0]

    def external_forces(self) -> Floats:
        """What supports and loads do to the rods as they are, shape (num_unknowns,), N and N mm.

        Their work on small changes of the unknowns is what goes into the rods, their contacts and friction. In
        equilibrium their forces cancel, and so do their moments, with those on rigid surfaces.
        """
        return self._reactions() + self._equilibria.applied(self.q)

    def _reactions(self) -> Floats:
        return self._unbalanced()[1]

    def _unbalanced(self) -> tuple[Floats, Floats]:
        """What nothing balances, and what supports do: shapes (num_unknowns,), N and N mm."""
        both, constraints = self._equilibria.unbalanced(self.q), self._equilibria.system.constraints
        left = np.zeros(both.size)
        left[constraints.free] = constraints.reduce(both)
        return left, both - left

    def contacts(self) -> dict[str, npt.NDArray[Any]]:
        """Results per contact element, see Contact.results; "tubes" are numbers of rods."""
        results = self.contact.results(self.q)
        surfaces, rods = results["tubes"], self.layout.surface_rods
        results["tubes"] = np.where(surfaces < 0, surfaces, rods[np.maximum(surfaces, 0)])
        return results

    def draw(self, path: str | Path, by_tension: bool = False, **view: Any) -> Path:
        """Draws the rods as a PNG, a colour for each or by tension; see draw_rods for the view.

        The picture is drawn on the first process.
        """
        count = len(self.layout.first)
        lines = [self.positions(rod) for rod in range(count)]
        tension = [self.tension(rod) for rod in range(count)] if by_tension else None
        if self.comm.rank == 0:
            draw_rods(lines, list(self.layout.radius), Path(path), tension, **view)
        return Path(path)

    def elastic_energy(self) -> float:
        """Stored in the rods, mJ."""
        self._equilibria.system.set_state(self.q)
        return sum(self.comm.allreduce(body.energy()) for body in self.layout.bodies)

    def kinetic_energy(self) -> float:
        """Of the motion that `run` ended with, mJ."""
        return (
            0.0
            if self._inertia is None
            else 0.5 * float(self.layout.mass @ self._inertia.velocity**2)
        )
