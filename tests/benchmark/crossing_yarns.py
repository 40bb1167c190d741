"""Two crossing yarns of solids, pressed onto each other and slid with friction: forces and what they cost.

    ./braidx shell python3 tests/benchmark/crossing_yarns.py [--seeds 8 12]

Both ends of the lower yarn are held; those of the upper one move down by 0.5 mm, then along its axis by 1.5 mm. The
section is an o-grid of two rings; 8 seeds round it make 3750 unknowns, 12 make 8880.
"""

from __future__ import annotations

import argparse
import resource
import time
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from braidx.bodies import SolidBody, YarnMaterial
from braidx.contact.contact import Contact
from braidx.contact.skins import SkinLayout
from braidx.contact.tubes import TubeLayout
from braidx.meshing import SolidMesh, join, round_section, sweep
from braidx.solver.increment import Increment, Incrementer, IncrementOptions
from braidx.solver.newton import Newton, NewtonOptions
from braidx.system.constraints import Constraints
from braidx.system.global_system import GlobalSystem
from braidx.system.proximal import ProximalTerm
from braidx.system.terms import BodyTerm

Floats = npt.NDArray[np.float64]

RADIUS, LENGTH = 1.0, 10.0  # mm
MODULUS, POISSON, FRICTION = 1000.0, 0.3, 0.2
PENALTY = 20.0 * MODULUS / RADIUS  # N/mm per mm^2
PRESS, SLIDE = 0.5, 1.5  # mm
INCREMENTS = (10, 20)  # of pressing and sliding
NO_TUBES = TubeLayout(*(np.empty(0, int),) * 4, np.empty(0), np.empty(0), np.empty(0, int))


@dataclass(frozen=True)
class Outcome:
    """Forces on the upper yarn when pressed and at the end, N, positive against the motion, and cost."""

    unknowns: int
    pressed: float
    normal: float
    tangential: float
    iterations: int
    updates: int
    seconds: float
    megabytes: float  # the most that the process has taken so far


def yarn(seeds: int, axis: int, height: float) -> SolidMesh:
    """A straight yarn along x (axis 0) or y (1), with a row of nodes along its top and bottom."""
    line = np.zeros((3 * seeds + 1, 3))
    line[:, axis] = np.linspace(-LENGTH / 2, LENGTH / 2, len(line))
    line[:, 2] = height
    directors = [np.eye(3)[2], np.cross(np.eye(3)[axis], np.eye(3)[2])]
    section = round_section(RADIUS, seeds, rings=2)
    return sweep(line, section, np.broadcast_to(directors, (len(line), 2, 3)))


class CrossingYarns:
    """The scene.

    Attributes:
        q: Unknowns now, shape (num_unknowns,), mm.
    """

    def __init__(self, seeds: int) -> None:
        mesh = join([yarn(seeds, 0, 0.0), yarn(seeds, 1, 2.0 * RADIUS)])
        material = YarnMaterial.isotropic(MODULUS, POISSON)
        body = SolidBody(MPI.COMM_SELF, mesh, material=material, law="Saint-Venant-Kirchhoff")
        self.q = body.rest.ravel().copy()
        contact = self._contact(body)
        proximal = ProximalTerm(self.q.size)
        lower, self._upper = (self._ends(mesh, part) for part in range(2))
        constraints = Constraints(self.q.size)
        self._values = np.zeros(self.q.size)
        for ends in (lower, self._upper):
            constraints.hold(ends.ravel())
            self._values[ends] = self.q[ends]
        self._system = GlobalSystem(
            MPI.COMM_SELF,
            [BodyTerm(body, 0), contact, proximal],
            constraints.resolve(),
            self._values,
        )
        options = NewtonOptions(
            max_step=0.5 * RADIUS,
            symmetric=False,
            petsc={"mat_mumps_icntl_7": 5},
            least_force=1e-3 * MODULUS * RADIUS**2,
        )
        newton = Newton(self._system, options, np.zeros(self.q.size, dtype=bool))
        self._incrementer = Incrementer(newton, contact, proximal)

    def _contact(self, body: SolidBody) -> Contact:
        facets = tuple(3 * body.facet_nodes("lateral", part) for part in range(2))
        # Dense points: edges of the coarse sections are where yarns touch first.
        skins = SkinLayout(facets, np.zeros(2, int), np.full(2, -1), np.full(2, RADIUS), dense=True)
        contact = Contact(
            MPI.COMM_SELF, NO_TUBES, smooth=True, symmetric=False, skins=skins, rest=self.q
        )
        contact.pairing.area_stiffness = PENALTY
        contact.pairing.search.margin = 0.3 * RADIUS
        contact.laws.friction = [FRICTION]
        contact.laws.regularisation = contact.laws.reversible_slip = 1e-3 * RADIUS
        return contact

    @staticmethod
    def _ends(mesh: SolidMesh, part: int) -> npt.NDArray[np.int64]:
        """Unknowns of the nodes of both ends of a yarn, shape (n, 3)."""
        layers = mesh.sweeps[part].layers
        return 3 * layers[[0, -1]].reshape(-1, 1) + np.arange(3)

    def move(self, by: Floats) -> Increment:
        """Moves the ends of the upper yarn, shape (3,), mm."""
        self._values[self._upper] += by
        first = self._system.expand(self._system.free_values(self.q))
        increment = self._incrementer.solve(self.q, first, IncrementOptions())
        self.q = increment.q
        return increment

    def force(self) -> Floats:
        """That holds the ends of the upper yarn, shape (3,), N."""
        self._system.set_state(self.q)
        return np.asarray(self._system.residual()[self._upper].sum(axis=0))


def run(
    seeds: int, press: float = PRESS, slide: float = SLIDE, increments: tuple[int, int] = INCREMENTS
) -> Outcome:
    """Presses and slides in equal increments."""
    start = time.perf_counter()
    yarns = CrossingYarns(seeds)
    down, along = np.array([0.0, 0.0, -press]), np.array([0.0, slide, 0.0])
    done = [yarns.move(down / increments[0]) for _ in range(increments[0])]
    pressed = -yarns.force()[2]
    done += [yarns.move(along / increments[1]) for _ in range(increments[1])]
    _, tangential, upward = yarns.force()
    return Outcome(
        yarns.q.size,
        float(pressed),
        float(-upward),
        float(tangential),
        sum(increment.iterations for increment in done),
        sum(increment.updates for increment in done),
        time.perf_counter() - start,
        resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, nargs="+", default=[8, 12])
    print(
        "| unknowns | pressed (N) | normal (N) | tangential (N) | iterations | updates | s | MB |"
    )
    print("|" + " ---: |" * 8)
    for seeds in parser.parse_args().seeds:
        o = run(seeds)
        print(
            f"| {o.unknowns} | {o.pressed:.2f} | {o.normal:.2f} | {o.tangential:.2f} "
            f"| {o.iterations} | {o.updates} | {o.seconds:.1f} | {o.megabytes:.0f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
