"""Sections of solids: unknowns like those of a beam's nodes, for supports, loads and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..geometry.frames import rotation_minimising_frames
from ..system.constraints import Constraints
from ..system.terms import Floats, Ints
from .closed import ring_directors
from .rod import Beam, Solid

Follow = tuple[Ints, Ints, Floats]  # followers, leaders and factors, see Constraints.combine_each


@dataclass(frozen=True)
class SolidSections:
    """A solid's sections, 9 unknowns each: centre x0 and directors g1, g2.

    The nodes of the first and the last section follow it, x = x0 + xi1 g1 + xi2 g2; those between follow their nodes,
    as the same formula fits them best. Forces on a section thus pass to its nodes.

    Attributes:
        solid: The rod.
        first: First unknown of its sections.
        nodes: First unknown of each node of each section, shape (num_sections, nodes_per_section).
        weights: Area of each node of a section, shape (nodes_per_section,), mm^2.
    """

    solid: Solid
    first: int
    nodes: Ints
    weights: Floats

    @property
    def num_sections(self) -> int:
        return len(self.nodes)

    def rest(self) -> Floats:
        """Sections as they are at rest, shape (num_sections, 9)."""
        line = np.asarray(self.solid.line, dtype=np.float64)
        return np.hstack([line, directors_of(self.solid).reshape(len(line), 6)])

    @property
    def inner(self) -> Ints:
        """Unknowns of the sections between the ends, which cannot be held."""
        return np.arange(self.first + 9, self.first + 9 * (self.num_sections - 1))

    def constrain(self, constraints: Constraints) -> None:
        """Has ends lead their nodes, and sections between them follow theirs."""
        for followers, leaders, factors in self._follow:
            constraints.combine_each(followers, leaders, factors)

    def mass(self, lengths: Floats) -> tuple[Ints, Floats]:
        """Unknowns that have mass, and their masses, t and, on directors, t mm^2.

        Args:
            lengths: That each section stands for, shape (num_sections,), mm.
        """
        density, xi = self.solid.density, self._section()
        second = [self.weights.sum(), *(self.weights @ xi**2)]
        ends = self.first + 9 * np.array([[0], [self.num_sections - 1]]) + np.arange(9)
        of_ends = density * lengths[[0, -1], None] * np.repeat(second, 3)
        between = self.nodes[1:-1, :, None] + np.arange(3)
        own = density * lengths[1:-1, None, None] * self.weights[:, None] * np.ones(3)
        return np.append(ends, between), np.append(of_ends, own)

    def _section(self) -> Floats:
        assert self.solid.section is not None
        return self.solid.section.points

    @cached_property
    def _follow(self) -> list[Follow]:
        place: Floats = np.asarray(np.column_stack([np.ones(len(self.weights)), self._section()]))
        fit = np.asarray(np.linalg.solve(place.T * self.weights @ place, place.T * self.weights))
        axes = np.arange(3)
        sections = self.first + 9 * np.arange(self.num_sections)
        # Of an unknown (section, node, axis) the leaders are (section, :, axis) and the other way round.
        led = sections[:, None, None] + 3 * np.arange(3)[:, None] + axes
        nodes = self.nodes[:, :, None] + axes
        ends, between = [0, self.num_sections - 1], slice(1, -1)
        return [
            _each(nodes[ends], led[ends], place),
            _each(led[between], nodes[between], fit),
        ]


def _each(followers: Ints, leaders: Ints, factors: Floats) -> Follow:
    """Followers (s, n, 3) follow leaders (s, k, 3) of the same section and axis with factors (n, k)."""
    shape = (*followers.shape, leaders.shape[1])
    of = np.broadcast_to(leaders.transpose(0, 2, 1)[:, None], shape)
    by = np.broadcast_to(factors[None, :, None], shape)
    return followers.ravel(), of.reshape(-1, shape[-1]), by.reshape(-1, shape[-1])


def directors_of(rod: Beam | Solid) -> Floats:
    """Directors at rest, shape (num_nodes, 2, 3)."""
    if rod.directors is None and rod.closed:
        return ring_directors(np.asarray(rod.line, dtype=float))
    if rod.directors is None:
        return rotation_minimising_frames([rod.line])[0]
    return np.asarray(rod.directors, dtype=np.float64)
