"""The bodies of a bent rope, and where their unknowns are among all of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI
from scipy.interpolate import CubicSpline

from ...bodies import BeamBody, CableBody, CurveBody
from ...geometry.frames import rotation_minimising_frames
from ...bodies.solid import SolidBody
from ...scene import Scene
from ...system.constraints import Floats
from ...system.terms import Body
from . import curves, solids
from .clamp import SIZE, Clamp
from .curves import Line
from .pieces import Piece
from .sheave import SheaveFrame, SheavePlace
from .stretches import Stretch


class Assembly:
    """All bodies of a bent rope, numbered one after the other, the two clamps and the sheave last.

    Attributes:
        bodies: Each with the number of its first unknown.
        cables, beams, solids: Those that yarns, and a core that is a beam, are in, with that number; or None.
        core_solid: The core if it is a solid, with that number; or None.
        pieces: One per stretch, in their order.
        core: The core's piece, or None.
        clamps: At the start and at the end of the rope.
        sheave: What the sheave turns with.
        start: All unknowns of the straight rope, shape (num_unknowns,).

    Args:
        comm, scene: As of the run.
        lines: Centre lines of the straight rope, shape (num_nodes, 3) each, mm; their ends lie in two planes.
        stretches: What yarns are modelled as.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        scene: Scene,
        lines: Sequence[Floats],
        stretches: Sequence[Stretch],
    ) -> None:
        self.scene, self.lines, self.stretches = scene, tuple(lines), tuple(stretches)
        self.bodies: list[tuple[Body, int]] = []
        self.core: Piece | None = None
        self._comm, self._size = comm, 0
        self._rest: list[Floats] = []
        self._pieces: dict[Stretch, Piece] = {}
        self._refine(solids.layers_per_element(scene))
        self.cables = self._add_cables()
        self.beams = self._add_beams()
        self.solids = self._add_solids()
        self.core_solid = self._add_core_solid()
        self.pieces = [self._pieces[stretch] for stretch in stretches]
        start, end = lines[0][0, 2], lines[0][-1, 2]
        self.clamps = self._add_clamp(start), self._add_clamp(end)
        self.sheave = self._add_sheave()
        self.start: Floats = np.concatenate(self._rest)

    @property
    def core_is_beam(self) -> bool:
        """Whether the core is the last curve of the beams."""
        return self.scene.core is not None and self.scene.core.model == "beam"

    def yarns(self) -> list[list[Piece]]:
        """The pieces of each yarn, from its start to its end."""
        out: list[list[Piece]] = [[] for _ in self.lines]
        for stretch, piece in zip(self.stretches, self.pieces, strict=True):
            out[stretch.yarn].append(piece)
        return out

    def _refine(self, layers: int) -> None:
        """Layers of nodes of solids between the nodes of curves, and frames that all of them share."""
        self._layers = layers
        self._fine = []
        for line in self.lines:
            node = np.arange(len(line))
            fine = CubicSpline(node, line)(np.arange((len(line) - 1) * layers + 1) / layers)
            fine[::layers] = line
            self._fine.append(fine)
        self._frames = rotation_minimising_frames(self._fine)

    def _add_cables(self) -> tuple[CableBody, int] | None:
        mine = self.of("cable")
        if not mine:
            return None
        body = curves.cables(self._comm, self.scene, [self._line(stretch) for stretch in mine])
        return body, self._add_curves(body, mine)

    def _add_beams(self) -> tuple[BeamBody, int] | None:
        mine, core = self.of("beam"), None
        if self.core_is_beam:
            core = curves.core_line(self.scene, len(self.lines[0]) - 1)
        if not mine and core is None:
            return None
        lines = [self._line(stretch) for stretch in mine]
        body = curves.beams(self._comm, self.scene, lines, core)
        first = self._add_curves(body, mine)
        if core is not None:
            nodes = np.arange(body.curves[-2], body.curves[-1])
            self.core = Piece(first + body.block * nodes[:, None], directors=True)
        return body, first

    def _add_solids(self) -> tuple[SolidBody, int] | None:
        mine = self.of("solid")
        if not mine:
            return None
        layers = self._layers
        fine = [slice(s.first * layers, s.last * layers + 1) for s in mine]
        lines = [self._fine[s.yarn][nodes] for s, nodes in zip(mine, fine, strict=True)]
        frames = [self._frames[s.yarn][nodes] for s, nodes in zip(mine, fine, strict=True)]
        body = solids.yarn_solids(self._comm, self.scene, lines, frames)
        first = self._add(body, body.rest)
        for part, stretch in enumerate(mine):
            sweep = body.mesh.sweeps[part]
            self._pieces[stretch] = Piece(first + 3 * sweep.layers[::layers], sweep=sweep)
        return body, first

    def _add_core_solid(self) -> tuple[SolidBody, int] | None:
        if self.scene.core is None or self.scene.core.model != "solid":
            return None
        body = solids.core_solid(self._comm, self.scene)
        first = self._add(body, body.rest)
        sweep = body.mesh.sweeps.get(0)
        if sweep is not None:
            self.core = Piece(first + 3 * sweep.layers, sweep=sweep)
        else:
            sections = solids.sections_along(body.mesh, self.scene.length)
            self.core = Piece(tuple(first + 3 * nodes for nodes in sections))
        return body, first

    def of(self, model: str) -> list[Stretch]:
        """Stretches of a model, in the order of the curves or parts of their body."""
        return [stretch for stretch in self.stretches if stretch.model == model]

    def _line(self, stretch: Stretch) -> Line:
        directors = self._frames[stretch.yarn][:: self._layers][stretch.nodes]
        return Line(self.lines[stretch.yarn][stretch.nodes], directors)

    def _add_curves(self, body: CurveBody, mine: Sequence[Stretch]) -> int:
        first = self._add(body, body.rest)
        for curve, stretch in enumerate(mine):
            nodes = np.arange(*body.curves[[curve, curve + 1]])
            self._pieces[stretch] = Piece(first + body.block * nodes[:, None], body.block == 9)
        return first

    def _add(self, body: Body, rest: Floats) -> int:
        first = self._size
        self.bodies.append((body, first))
        self._size += body.num_unknowns
        self._rest.append(rest.ravel())
        return first

    def _add_sheave(self) -> SheaveFrame:
        place, sheave = SheavePlace.below(self.scene, self.lines), self.scene.sheave
        frame = SheaveFrame(
            self._size, place.centre, sheave is not None and sheave.motion == "free"
        )
        self._size += frame.SIZE
        self._rest.append(frame.start)
        return frame

    def _add_clamp(self, height: float) -> Clamp:
        clamp = Clamp(self._size, height)
        self._size += SIZE
        self._rest.append(clamp.start)
        return clamp
