"""The bodies of a bent rope, and where their unknowns are among all of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI

from ...bodies import BeamBody, CableBody, CurveBody
from ...bodies.frames import rotation_minimising_frames
from ...contact.tubes import TubeLayout
from ...scene import Scene
from ...system.constraints import Constraints, Floats, Ints
from ...system.terms import Body
from . import curves
from .clamp import SIZE, Clamp
from .curves import Line
from .pieces import Piece, join
from .stretches import Stretch

YARN, CORE, SHEAVE = range(3)  # bodies, as far as friction is concerned


class Assembly:
    """All bodies of a bent rope, numbered one after the other, the two clamps last.

    Attributes:
        bodies: Each with the number of its first unknown.
        cables, beams: Those among them that are curves, with that number; None where there are none.
        pieces: One per stretch, in their order.
        core: The core's piece, or None.
        clamps: At the start and at the end of the rope.
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
        self.scene, self.stretches = scene, stretches
        self.bodies: list[tuple[Body, int]] = []
        self._frames = rotation_minimising_frames(lines)
        self._lines = lines
        self._size = 0
        self._rest: list[Floats] = []
        self._pieces: dict[Stretch, Piece] = {}
        self.core: Piece | None = None
        self.cables = self._add_cables(comm)
        self.beams = self._add_beams(comm)
        self.pieces = [self._pieces[stretch] for stretch in stretches]
        heights = lines[0][0, 2], lines[0][-1, 2]
        self.clamps = (self._add_clamp(heights[0]), self._add_clamp(heights[1]))
        self.start: Floats = np.concatenate(self._rest)

    @property
    def core_is_beam(self) -> bool:
        """Whether the core is the last curve of the beams."""
        return self.scene.core is not None and self.scene.core.model == "beam"

    def constraints(self) -> tuple[Constraints, Floats]:
        """Yarns made whole, everything clamped at both ends, the clamps held in the plane of bending.

        Ends of the rope move alike along the axis. Returns the constraints and their values, shape (num_unknowns,).
        """
        constraints, values = Constraints(len(self.start)), np.zeros(len(self.start))
        for clamp in self.clamps:
            clamp.hold(constraints, values)
        first, last = (clamp.axial for clamp in self.clamps)
        constraints.combine(first, [last], [-1.0])
        values[first] = self.start[first] + self.start[last]
        numbered = list(zip(self.stretches, self.pieces, strict=True))
        for (one, before), (two, after) in zip(numbered[:-1], numbered[1:], strict=True):
            if one.yarn == two.yarn:
                join(constraints, values, before, after, self.start)
        for number, (stretch, piece) in enumerate(numbered):
            if number == 0 or numbered[number - 1][0].yarn != stretch.yarn:
                piece.clamp(constraints, 0, self.clamps[0], self.start)
            if number + 1 == len(numbered) or numbered[number + 1][0].yarn != stretch.yarn:
                piece.clamp(constraints, -1, self.clamps[1], self.start)
        if self.core is not None:
            for section, clamp in zip((0, -1), self.clamps, strict=True):
                self.core.clamp(constraints, section, clamp, self.start)
                if self.core.directors:
                    component = np.arange(3, SIZE)
                    node = self.core.positions[section, 0]
                    constraints.tie(node + component, clamp.first_unknown + component)
        return constraints, values

    def centre_lines(self, q: Floats) -> tuple[Floats, ...]:
        """Centre lines of all yarns, shape (num_nodes, 3) each, mm, with the nodes of the straight rope."""
        out = [np.empty_like(line) for line in self._lines]
        for stretch, piece in zip(self.stretches, self.pieces, strict=True):
            out[stretch.yarn][stretch.nodes] = piece.centre_line(q)
        return tuple(out)

    def directors(self, q: Floats) -> tuple[Floats, ...] | None:
        """Sections of yarns, shape (num_nodes, 2, 3) each, if all of them are beams from end to end."""
        if any(not piece.directors for piece in self.pieces):
            return None
        return tuple(piece.sections(q) for piece in self.pieces)

    def axial_stress(self, q: Floats) -> tuple[Floats, ...]:
        """Axial force of yarns over their section at rest, between the nodes of centre lines, MPa."""
        out = [np.empty(len(line) - 1) for line in self._lines]
        for part in (self.cables, self.beams):
            if part is None:
                continue
            body, first = part
            rows = q[first : first + body.num_unknowns].reshape(-1, body.block)
            stress = body.axial_stress(rows)
            for curve, stretch in enumerate(s for s in self.stretches if self._is_in(s, body)):
                elements = slice(*body.layout.curve_elements[[curve, curve + 1]])
                out[stretch.yarn][stretch.first : stretch.last] = stress[elements]
        return tuple(out)

    @property
    def surface_yarn(self) -> Ints:
        """Yarn that each surface of the contact engine belongs to, -1 for the core."""
        yarns = [s.yarn for model in ("cable", "beam") for s in self.stretches if s.model == model]
        return np.array(yarns + [-1] * self.core_is_beam, dtype=np.int64)

    @staticmethod
    def _is_in(stretch: Stretch, body: CurveBody) -> bool:
        return stretch.model == ("beam" if body.block == 9 else "cable")

    def tubes(self) -> TubeLayout:
        """All curves as tubes of the contact engine."""
        parts = [part for part in (self.cables, self.beams) if part is not None]
        columns: dict[str, list[Ints | Floats]] = {}
        for body, first in parts:
            layout = body.layout
            count = np.diff(layout.curve_elements)
            length = np.add.reduceat(body.rest_lengths(), layout.curve_elements[:-1])
            ones = np.ones(len(count), dtype=np.int64)
            radius, kind = self.scene.yarn.radius * np.ones(len(count)), YARN * ones
            if body.block == 9 and self.core_is_beam:
                assert self.scene.core is not None
                radius[-1], kind[-1] = self.scene.core.radius, CORE
            for name, values in {
                "first_unknown": first + layout.curves[:-1] * body.block,
                "num_elements": count,
                "degree": layout.degree * ones,
                "block": body.block * ones,
                "radius": radius,
                "element_length": length / count,
                "body": kind,
            }.items():
                columns.setdefault(name, []).append(values)
        return TubeLayout(**{name: np.concatenate(values) for name, values in columns.items()})

    def _add_cables(self, comm: MPI.Comm) -> tuple[CableBody, int] | None:
        mine = [stretch for stretch in self.stretches if stretch.model == "cable"]
        if not mine:
            return None
        body = curves.cables(comm, self.scene, [self._line(stretch) for stretch in mine])
        return body, self._add_curves(body, mine)

    def _add_beams(self, comm: MPI.Comm) -> tuple[BeamBody, int] | None:
        mine = [stretch for stretch in self.stretches if stretch.model == "beam"]
        core = None
        if self.core_is_beam:
            core = curves.core_line(self.scene, len(self._lines[0]) - 1)
        if not mine and core is None:
            return None
        body = curves.beams(comm, self.scene, [self._line(stretch) for stretch in mine], core)
        first = self._add_curves(body, mine)
        if core is not None:
            nodes = np.arange(body.curves[-2], body.curves[-1])
            self.core = Piece(first + body.block * nodes[:, None], directors=True)
        return body, first

    def _line(self, stretch: Stretch) -> Line:
        points = self._lines[stretch.yarn][stretch.nodes]
        return Line(points, self._frames[stretch.yarn][stretch.nodes], self.scene.yarn.radius)

    def _add_curves(self, body: CurveBody, mine: Sequence[Stretch]) -> int:
        first = self._add(body, body.rest)
        for curve, stretch in enumerate(mine):
            nodes = np.arange(*body.curves[[curve, curve + 1]])
            positions = first + body.block * nodes[:, None]
            self._pieces[stretch] = Piece(positions, body.block == 9, stretch.first)
        return first

    def _add(self, body: Body, rest: Floats) -> int:
        first = self._size
        self.bodies.append((body, first))
        self._size += body.num_unknowns
        self._rest.append(rest.ravel())
        return first

    def _add_clamp(self, height: float) -> Clamp:
        clamp = Clamp(self._size, height)
        self._size += SIZE
        self._rest.append(clamp.start)
        return clamp
