"""Rods as bodies, tubes and unknowns, which are numbered body by body, rod by rod, node by node."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from mpi4py import MPI

from ..bodies import BeamBody, BeamSection, CableBody, CurveBody
from ..bodies.frames import rotation_minimising_frames
from ..contact.tubes import TubeLayout
from ..system.terms import Floats, Ints
from .rod import Beam, Cable, Rod


@dataclass(frozen=True)
class Layout:
    """Where things are among all unknowns.

    Attributes:
        bodies: Rods of one model and degree are one body.
        first_body: First unknown of each body, shape (num_bodies,).
        first: First unknown of each rod, shape (num_rods,).
        block: Unknowns of a node of each rod, 3 or 9, shape (num_rods,).
        num_nodes: shape (num_rods,).
        rest: Unknowns at rest, shape (num_unknowns,).
        lengths: Length of rod that each unknown stands for, shape (num_unknowns,), mm.
        mass: Of each unknown, t on positions and t mm^2 on directors, shape (num_unknowns,).
        is_director: shape (num_unknowns,).
        tubes: What contact sees.
        place: Body and curve of each rod, shape (num_rods, 2).
        round_off: Norm of what round-off of positions leaves of axial forces, N: no residual gets smaller.
    """

    bodies: tuple[CurveBody, ...]
    first_body: Ints
    first: Ints
    block: Ints
    num_nodes: Ints
    rest: Floats
    lengths: Floats
    mass: Floats
    is_director: np.ndarray
    tubes: TubeLayout
    place: Ints
    round_off: float

    def unknowns(self, rod: int, nodes: int | slice | Sequence[int]) -> Ints:
        """Unknowns of nodes of a rod, shape (n, block); nodes may count from the end.

        Raises:
            IndexError: If there is no such rod or node.
        """
        if not 0 <= rod < len(self.first):
            raise IndexError(f"rod {rod}: there are rods 0 to {len(self.first) - 1}")
        chosen = np.atleast_1d(np.arange(self.num_nodes[rod])[nodes])
        block = self.block[rod]
        return np.asarray(self.first[rod] + block * chosen[:, None] + np.arange(block))


def lay_out(comm: MPI.Comm, rods: Sequence[Rod]) -> Layout:
    """Makes bodies of rods.

    Raises:
        ValueError: If there is no rod, or one with an impossible value; the message names it.
    """
    if not rods:
        raise ValueError("rods is empty: give one Cable or Beam at least")
    groups: dict[tuple[type, int, str], list[int]] = {}
    for number, rod in enumerate(rods):
        natural = rod.natural_state if isinstance(rod, Beam) else ""
        groups.setdefault((type(rod), rod.degree, natural), []).append(number)
    bodies = tuple(_body(comm, [rods[i] for i in members]) for members in groups.values())
    first_body = np.cumsum([0, *(body.num_unknowns for body in bodies)])
    order = np.concatenate(list(groups.values()))
    tubes = _joined(
        [
            body_tubes(body, [rods[i].radius for i in members], int(first))
            for body, members, first in zip(bodies, groups.values(), first_body[:-1], strict=True)
        ],
        order,
    )
    sizes = [len(members) for members in groups.values()]
    place = np.empty((len(rods), 2), dtype=np.int64)
    place[order, 0] = np.repeat(np.arange(len(sizes)), sizes)
    place[order, 1] = np.concatenate([np.arange(size) for size in sizes])
    first, block, spans = tubes.first_unknown, tubes.block, tubes.element_length
    rest = np.concatenate([body.rest.ravel() for body in bodies])
    lengths, mass, is_director = (np.zeros(rest.size) for _ in range(3))
    num_nodes = np.array([len(rod.line) for rod in rods])
    for number, rod in enumerate(rods):
        own = slice(first[number], first[number] + block[number] * num_nodes[number])
        share = nodal_lengths(rod.line, rod.degree)
        lengths[own] = share.repeat(block[number])
        mass[own] = (share[:, None] * _mass_per_length(rod)).ravel()
        is_director[own] = np.tile(np.arange(block[number]) >= 3, num_nodes[number])
    return Layout(
        bodies,
        first_body[:-1],
        first,
        block,
        num_nodes,
        rest,
        lengths,
        mass,
        is_director.astype(bool),
        tubes,
        place,
        float(np.linalg.norm([_round_off(rod, h) for rod, h in zip(rods, spans, strict=True)])),
    )


def body_tubes(body: CurveBody, radius: npt.ArrayLike, first_unknown: int = 0) -> TubeLayout:
    """Tubes around the curves of a body, all of one body as friction sees it.

    Args:
        radius: mm, shape (num_curves,) or one for all.
        first_unknown: Of the body.
    """
    curves, elements = body.curves, body.layout.curve_elements
    ones = np.ones(len(curves) - 1, dtype=np.int64)
    return TubeLayout(
        first_unknown=first_unknown + body.block * curves[:-1],
        num_elements=np.diff(elements),
        degree=body.layout.degree * ones,
        block=body.block * ones,
        radius=np.asarray(radius, dtype=float) * ones,
        element_length=np.add.reduceat(body.rest_lengths(), elements[:-1]) / np.diff(elements),
        body=0 * ones,
    )


def _joined(parts: Sequence[TubeLayout], order: Ints) -> TubeLayout:
    """Tubes of several bodies, each where `order` tells, shape (num_tubes,)."""
    back = np.argsort(order)
    names = ("first_unknown", "num_elements", "degree", "block", "radius", "element_length", "body")
    return TubeLayout(
        **{name: np.concatenate([getattr(part, name) for part in parts])[back] for name in names}
    )


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


def _round_off(rod: Rod, span: float) -> float:
    """Strains are differences of positions over the length of an element: norm over the nodes of the rod, N.

    Residuals that got no smaller were found to be 1.4 to 2.2 times the product of these; 4 leaves some room.
    """
    size = float(np.abs(rod.line).max() + np.ptp(rod.line))
    axial = 4.0 * np.finfo(float).eps * rod.constrained_stiffness * size / span
    return float(axial * np.sqrt(len(rod.line)))


def _mass_per_length(rod: Rod) -> Floats:
    section = rod.section
    assert section is not None
    parts = [section.area] * 3
    if isinstance(rod, Beam):
        parts += [section.inertia_1] * 3 + [section.inertia_2] * 3
    return rod.density * np.array(parts)


def _body(comm: MPI.Comm, rods: Sequence[Rod]) -> CurveBody:
    lines = [np.asarray(rod.line, dtype=np.float64) for rod in rods]
    degree, tension = rods[0].degree, [rod.tension for rod in rods]
    if isinstance(rods[0], Cable):
        return CableBody(
            comm,
            lines,
            axial_stiffness=[rod.axial_stiffness for rod in rods if isinstance(rod, Cable)],
            tension=tension,
            degree=degree,
            area=[rod.section.area for rod in rods if isinstance(rod, Cable)],
        )
    beams = [rod for rod in rods if isinstance(rod, Beam)]
    factors = [beam.bundle_factor for beam in beams]
    return BeamBody(
        comm,
        lines,
        section=[_section(beam) for beam in beams],
        material=[beam.material for beam in beams],
        directors=[_directors(beam) for beam in beams],
        degree=degree,
        bundle_factor=factors,
        torsion_factor=[
            factor if beam.torsion_factor is None else beam.torsion_factor
            for beam, factor in zip(beams, factors, strict=True)
        ],
        natural_state=beams[0].natural_state,
        tension=tension,
    )


def _section(beam: Beam) -> BeamSection:
    assert beam.section is not None
    return beam.section


def _directors(beam: Beam) -> Floats:
    if beam.directors is None:
        return rotation_minimising_frames([beam.line])[0]
    return np.asarray(beam.directors, dtype=np.float64)
