"""Rods as bodies, surfaces and unknowns.

Unknowns are numbered body by body, rod by rod, node by node; sections of solids come last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from mpi4py import MPI

from ..bodies import CurveBody, SolidBody
from ..geometry.frames import check_right_handed
from ..contact.skins import SkinLayout
from ..contact.tubes import TubeLayout
from ..system.terms import Floats, Ints
from .closed import Joints, check_rings
from .frames import SIZE, Frame
from .make_bodies import make_body
from .rod import Beam, Cable, Rod, Solid
from .sections import SolidSections
from .surfaces import skins_of, tubes_of


Nodes = int | slice | Sequence[int]


@dataclass(frozen=True)
class Layout:
    """Where things are among all unknowns.

    Attributes:
        bodies: Rods of one model and degree are one body.
        first_body: First unknown of each body, shape (num_bodies,).
        first: First unknown of each rod, of a solid that of its sections, shape (num_rods,).
        block: Unknowns of a node of each rod, 3 or 9, shape (num_rods,).
        num_nodes, degree: shape (num_rods,).
        radius: shape (num_rods,), mm.
        rest: Unknowns at rest, shape (num_unknowns,).
        lengths: Length of rod that each unknown stands for, shape (num_unknowns,), mm; 0 of nodes of solids.
        mass: Of each unknown, t on positions and t mm^2 on directors, shape (num_unknowns,).
        is_director: shape (num_unknowns,).
        tubes, skins: What contact sees of cables and beams, and of solids.
        surface_rods: Rod of each surface, tubes first, shape (num_rods,).
        sections: Of each solid, by number of the rod.
        joints: Of closed rods.
        place: Body, and curve or part in it, of each rod, shape (num_rods, 2).
        frames: Rigid bodies that nodes are part of; their numbers follow those of the rods.
        round_off: Norm of what round-off of positions leaves of internal forces, N: no residual gets smaller.
    """

    bodies: tuple[CurveBody | SolidBody, ...]
    first_body: Ints
    first: Ints
    block: Ints
    num_nodes: Ints
    degree: Ints
    radius: Floats
    rest: Floats
    lengths: Floats
    mass: Floats
    is_director: np.ndarray
    tubes: TubeLayout
    skins: SkinLayout | None
    surface_rods: Ints
    sections: dict[int, SolidSections]
    joints: Joints
    place: Ints
    round_off: float
    frames: tuple[Frame, ...] = ()

    @property
    def dependents(self) -> list[SolidSections | Joints]:
        """What follows other unknowns, or has others follow it."""
        return [*self.sections.values(), self.joints]

    def unknowns(self, rod: int, nodes: int | slice | Sequence[int]) -> Ints:
        """Unknowns of nodes of a rod, shape (n, block); nodes may count from the end.

        The last node of a closed rod is its first one. A frame has one node, of 12 unknowns.

        Raises:
            IndexError: If there is no such rod or node.
        """
        num_rods = len(self.first)
        if num_rods <= rod < num_rods + len(self.frames):
            return self.frames[rod - num_rods].unknowns[np.atleast_1d(np.arange(1)[nodes])]
        if not 0 <= rod < num_rods:
            joined = f", rigid groups and joints to {num_rods + len(self.frames) - 1}"
            raise IndexError(
                f"rod {rod}: there are rods 0 to {num_rods - 1}{joined if self.frames else ''}"
            )
        chosen = np.atleast_1d(np.arange(self.num_nodes[rod])[nodes])
        if rod in self.joints.rods:
            chosen %= self.num_nodes[rod] - 1
        block = self.block[rod]
        return np.asarray(self.first[rod] + block * chosen[:, None] + np.arange(block))

    def unknowns_to_hold(self, rod: int, nodes: int | slice | Sequence[int]) -> Ints:
        """Unknowns of nodes that a support can hold, as in `unknowns`.

        Raises:
            ValueError: If the rod is a solid and a node is none of its ends.
        """
        unknowns = self.unknowns(rod, nodes)
        if rod in self.sections:
            inner = np.isin(unknowns[:, 0], self.sections[rod].inner)
            if inner.any():
                node = int((unknowns[inner][0, 0] - self.first[rod]) // 9)
                raise ValueError(
                    f"node {node} of rod {rod} cannot be held: of a solid hold the ends, 0 and -1"
                )
        return unknowns


def with_frame(layout: Layout, frame: Frame) -> Layout:
    """The layout with one more frame, whose unknowns come after all others."""
    is_director = np.arange(SIZE) >= 3
    none = np.zeros(SIZE)
    return replace(
        layout,
        rest=np.append(layout.rest, frame.rest),
        lengths=np.append(layout.lengths, none),
        mass=np.append(layout.mass, none),
        is_director=np.append(layout.is_director, is_director),
        # Products of its directors, of size 1, are as exact as numbers are.
        round_off=float(np.hypot(layout.round_off, 4.0 * np.finfo(float).eps * frame.stiffness)),
        frames=(*layout.frames, frame),
    )


def lay_out(comm: MPI.Comm, rods: Sequence[Rod]) -> Layout:
    """Makes bodies of rods.

    Raises:
        ValueError: If there is no rod, or one with an impossible value; the message names it.
    """
    if not rods:
        raise ValueError("rods is empty: give one Cable, Beam or Solid at least")
    _check_directors(rods)
    check_rings(rods)
    groups = _groups(rods)
    bodies = tuple(make_body(comm, [rods[i] for i in members]) for members in groups)
    first_body = np.cumsum([0, *(body.num_unknowns for body in bodies)])
    place = np.empty((len(rods), 2), dtype=np.int64)
    for number, members in enumerate(groups):
        place[members] = np.column_stack([np.full(len(members), number), np.arange(len(members))])
    sections = _sections(rods, bodies, first_body, place)
    first = np.array([_first(i, bodies, first_body, place, sections) for i in range(len(rods))])
    block = np.array([3 if isinstance(rod, Cable) else 9 for rod in rods])
    rest = np.concatenate(
        [body.rest.ravel() for body in bodies] + [s.rest().ravel() for s in sections.values()]
    )
    lengths, mass, is_director = (np.zeros(rest.size) for _ in range(3))
    num_nodes = np.array([len(rod.line) for rod in rods])
    for number, rod in enumerate(rods):
        own = slice(first[number], first[number] + block[number] * num_nodes[number])
        share = nodal_lengths(rod.line, rod.degree)
        lengths[own] = share.repeat(block[number])
        is_director[own] = np.tile(np.arange(block[number]) >= 3, num_nodes[number])
        if isinstance(rod, Solid):
            unknowns, masses = sections[number].mass(share)
            mass[unknowns] = masses
        else:
            mass[own] = (share[:, None] * _mass_per_length(rod)).ravel()
    joints = Joints.of(rods, first, block)
    rest[joints.followers] = rest[joints.leaders]
    joints.fold(lengths)
    joints.fold(mass)
    curves = [i for i, rod in enumerate(rods) if not isinstance(rod, Solid)]
    return Layout(
        bodies,
        first_body[:-1],
        first,
        block,
        num_nodes,
        np.array([rod.degree for rod in rods]),
        np.array([rod.radius for rod in rods], dtype=float),
        rest,
        lengths,
        mass,
        is_director.astype(bool),
        tubes_of(rods, bodies, first_body, groups),
        skins_of(rods, bodies, first_body, place),
        np.array(curves + list(sections), dtype=np.int64),
        sections,
        joints,
        place,
        float(np.linalg.norm([_round_off(rod) for rod in rods])),
    )


def _check_directors(rods: Sequence[Rod]) -> None:
    for number, rod in enumerate(rods):
        if not isinstance(rod, Cable) and rod.directors is not None:
            line, given = np.asarray(rod.line, float), np.asarray(rod.directors, float)
            check_right_handed(line, given, f"directors of rod {number}")


def _groups(rods: Sequence[Rod]) -> list[list[int]]:
    """Rods that can be one body, curves before solids."""
    kinds = {Cable: (), Beam: ("natural_state", "axial_law"), Solid: ("law",)}
    groups: dict[tuple[Any, ...], list[int]] = {}
    for number, rod in enumerate(rods):
        kind = [getattr(rod, name) for name in kinds[type(rod)]]
        key = (isinstance(rod, Solid), type(rod).__name__, rod.degree, *kind)
        groups.setdefault(key, []).append(number)
    return [groups[key] for key in sorted(groups, key=lambda key: key[0])]


def _sections(
    rods: Sequence[Rod],
    bodies: Sequence[CurveBody | SolidBody],
    first_body: Ints,
    place: Ints,
) -> dict[int, SolidSections]:
    found: dict[int, SolidSections] = {}
    free = int(first_body[-1])
    for number, rod in enumerate(rods):
        body = bodies[place[number, 0]]
        if isinstance(rod, Solid) and isinstance(body, SolidBody):
            sweep = body.mesh.sweeps[int(place[number, 1])]
            nodes = first_body[place[number, 0]] + 3 * sweep.layers
            found[number] = SolidSections(rod, free, nodes, sweep.weights)
            free += 9 * len(rod.line)
    return found


def _first(
    rod: int,
    bodies: Sequence[CurveBody | SolidBody],
    first_body: Ints,
    place: Ints,
    sections: dict[int, SolidSections],
) -> int:
    """First unknown of the nodes, or of the sections, of a rod."""
    if rod in sections:
        return sections[rod].first
    number, curve = place[rod]
    body = bodies[number]
    assert isinstance(body, CurveBody)
    return int(first_body[number] + body.block * body.curves[curve])


def nodal_lengths(line: Floats, degree: int) -> Floats:
    """Length that each node of a rod stands for, shape (num_nodes,), mm: the integral of its shape function.

    Elements count by the lengths of their chords.
    """
    chords = np.linalg.norm(np.diff(line, axis=0), axis=1)
    share = np.zeros(len(line))
    if degree == 1:
        share[:-1] += chords / 2.0
        share[1:] += chords / 2.0
        return share
    element = chords[::2] + chords[1::2]
    share[:-1:2] += element / 6.0
    share[1::2] += 4.0 * element / 6.0
    share[2::2] += element / 6.0
    return share


def _round_off(rod: Rod) -> float:
    """Strains are differences of positions over the length of an element: norm over the nodes of the rod, N.

    Residuals that got no smaller were found to be 1.4 to 2.2 times the product of these; 4 leaves some room. Strains
    across a solid are so over its thickness, and their stresses act on its sides, not on its sections.
    """
    length = float(np.linalg.norm(np.diff(rod.line, axis=0), axis=1).sum())
    span = length * rod.degree / (len(rod.line) - 1)
    size = float(np.abs(rod.line).max() + np.ptp(rod.line))
    force = 4.0 * np.finfo(float).eps * rod.constrained_stiffness * size / span
    if isinstance(rod, Solid):
        return float(force * (1.0 + span**2 / rod.area) * np.sqrt(len(rod.line)))
    return float(force * np.sqrt(len(rod.line)))


def _mass_per_length(rod: Cable | Beam) -> Floats:
    section = rod.section
    assert section is not None
    parts = [section.area] * 3
    if isinstance(rod, Beam):
        parts += [section.inertia_1] * 3 + [section.inertia_2] * 3
    return rod.density * np.array(parts)
