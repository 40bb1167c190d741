"""What can be asked of a scene of rods as it is now."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

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
        number, curve = self.layout.place[rod]
        body, first = self.layout.bodies[number], self.layout.first_body[number]
        state = self.q[first : first + body.num_unknowns].reshape(-1, body.block)
        elements = slice(*body.layout.curve_elements[[curve, curve + 1]])
        return body.tension(state)[elements]

    def reaction(self, rod: int, node: int) -> tuple[Floats, Floats]:
        """Force (N) and moment about the node (N mm) that hold a node, shape (3,) each."""
        position = self.q[self.layout.unknowns(rod, node)[0, :3]]
        return self.resultant([(rod, node)], position)

    def resultant(
        self, places: Sequence[tuple[int, int]], about: npt.ArrayLike
    ) -> tuple[Floats, Floats]:
        """Force (N) and moment about a point (N mm) that hold nodes, given as (rod, node), shape (3,) each."""
        self._equilibria.system.set_state(self.q)
        forces = self._equilibria.system.residual()
        force, moment = np.zeros(3), np.zeros(3)
        for rod, node in places:
            unknowns = self.layout.unknowns(rod, node)[0]
            arms, parts = (values[unknowns].reshape(-1, 3) for values in (self.q, forces))
            force += parts[0]
            moment += np.cross(arms[0] - np.asarray(about, dtype=float), parts[0])
            moment += np.cross(arms[1:], parts[1:]).sum(axis=0)
        return force, moment

    def contacts(self) -> dict[str, npt.NDArray[Any]]:
        """Results per contact element, see Contact.results; "tubes" are numbers of rods."""
        return self.contact.results(self.q)

    def draw(self, path: str | Path, by_tension: bool = False, **view: Any) -> Path:
        """Draws the rods as a PNG, a colour for each or by tension; see draw_rods for the view.

        The picture is drawn on the first process.
        """
        count = len(self.layout.first)
        lines = [self.positions(rod) for rod in range(count)]
        tension = [self.tension(rod) for rod in range(count)] if by_tension else None
        if self.comm.rank == 0:
            draw_rods(lines, list(self.layout.tubes.radius), Path(path), tension, **view)
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
