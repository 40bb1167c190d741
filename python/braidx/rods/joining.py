"""Rigid groups of nodes, and joints between rods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ..contact.contact import Contact
from ..system.terms import Floats, Ints
from .contact import keep_apart
from .frames import RIGID, Frame, carried
from .given import numbers
from .layout import Layout, Nodes
from .linked import Linked
from .places import Place, place_of
from .rod import Rod
from .supports import Supports

MEET = 1e-9  # of the size of the rods: what round-off may leave between two places that are one


class Joining:
    """What joins nodes of rods. See Rods."""

    q: Floats
    rods: list[Rod]
    layout: Layout
    supports: Supports
    contact: Contact
    _joined: list[tuple[int, Floats]]  # rods and where they are joined, mm

    def _grow(self, frame: Frame | None, links: Sequence[Linked]) -> None:
        """Takes in a frame, whose unknowns come last, and what follows others."""
        raise NotImplementedError

    def rigid(
        self,
        places: Sequence[tuple[int, Nodes]],
        centre: npt.ArrayLike | None = None,
        axis: npt.ArrayLike = (0.0, 0.0, 1.0),
    ) -> int:
        """Nodes, with their sections, move as one rigid body from now on.

        The group has one node, 0, and goes by a number as a rod does: it is held, moved, loaded and asked like a
        section. Its directors g1, g2, g3, components 3 to 11, are unit vectors at first, g3 along an axis. Rods of a
        group still touch each other.

        Args:
            places: Rods and nodes.
            centre: Of the group, where its forces act and its moments count, mm; the mean of the nodes by default.
        Returns:
            Number of the group.
        Raises:
            ValueError: If a node is held or follows something else already, or cannot be held.
        """
        members = [own for rod, nodes in places for own in self.layout.unknowns_to_hold(rod, nodes)]
        for rod, nodes in places:
            self._refuse_taken(rod, nodes, slice(None), "put the group in its place")
        for rod, _ in places:
            self._refuse_group(rod)
        if not members:
            raise ValueError("places is empty: give one (rod, node) at least")
        if len({int(own[0]) for own in members}) < len(members):
            raise ValueError(f"places is {list(places)}: a node is named twice")
        positions = self.q[np.array([own[:3] for own in members])]
        middle = positions.mean(axis=0) if centre is None else numbers("centre", centre, 3)
        rest = np.append(middle, _axes(numbers("axis", axis, 3)))
        rods = {rod for rod, _ in places}
        arm = float(np.linalg.norm(positions - middle, axis=1).max())
        first = self.q.size
        frame = Frame(first, self._rigidity(rods, arm), rest)
        self._grow(frame, [carried(first, rest, members, self.q)])
        return len(self.layout.first) + len(self.layout.frames) - 1

    def hinge(self, first: Place, second: Place) -> None:
        """A node of one rod stays where a place of another is: sections turn freely.

        The two rods do not touch each other from then on, nor do others that are joined there. A node off the centre
        line of a beam or a solid is joined to its section, with which it turns.

        Args:
            first: Rod and node.
            second: Rod and place along it, as a node number, 2.5 for halfway between nodes 2 and 3.
        Raises:
            ValueError: If the node is held or follows something else already, or is off the centre line of a cable.
        """
        self._join(first, second, with_section=False)

    def tie(self, first: Place, second: Place) -> None:
        """A node of one rod and its section move with the section at a place of another, as if welded to it.

        Contact is as in `hinge`.

        Args:
            first, second: As in `hinge`.
        Raises:
            ValueError: As in `hinge`, or if a rod is a cable.
        """
        self._join(first, second, with_section=True)

    def _join(self, first: Place, second: Place, with_section: bool) -> None:
        rod, node = first
        if not isinstance(node, int | np.integer):
            raise ValueError(f"first is {first}: give a rod and the number of one of its nodes")
        own = self.layout.unknowns_to_hold(rod, int(node))[0]
        self._refuse_taken(rod, int(node), slice(None if with_section else 3), "release it")
        unknowns, weights = place_of(self.layout, second)
        for number in (rod, second[0]):
            self._refuse_group(number)
        for number, block in ((rod, own.size), (second[0], unknowns.shape[1])):
            if with_section and block < 9:
                raise ValueError(
                    f"rod {number} is a cable, which has no section to tie: give a hinge"
                )
        own = own if with_section else own[:3]
        there = weights @ self.q[unknowns]
        apart = float(np.linalg.norm(self.q[own[:3]] - there[:3]))
        on_line = apart <= MEET * float(np.abs(self.layout.rest).max())
        if not on_line and unknowns.shape[1] < 9:
            raise ValueError(
                f"node {node} of rod {rod} is {apart:.3g} mm from the place {second[1]} of rod {second[0]}: a cable "
                "is joined where its line is, put the node there"
            )
        if not with_section and on_line:
            self._grow(None, [Linked.of(own[None, :], unknowns[None, :, :3], weights[None, :])])
        else:
            frame = self._frame_at(there, second[0], apart)
            to_frame = _vectors(unknowns[:, :9])
            follows = Linked.of(
                frame.vectors()[:3], to_frame, np.broadcast_to(weights, (3, weights.size))
            )
            self._grow(frame, [carried(frame.first, frame.rest, [own], self.q), follows])
        self._keep_apart(rod, second[0], there[:3])

    def _keep_apart(self, first: int, second: int, place: Floats) -> None:
        """The rods of a joint do not touch, nor do those of joints that are within their radii."""
        near = {first, second}
        for rod, position in self._joined:
            reach = sum(float(self.rods[i].radius) for i in (first, second, rod))
            if float(np.linalg.norm(position - place)) < reach:
                near.add(rod)
        for a in near:
            for b in near - {a} if first != second else near:
                keep_apart(self.contact, a, b)
        self._joined += [(first, place), (second, place)]

    def _refuse_group(self, rod: int) -> None:
        if rod >= len(self.rods):
            raise ValueError(
                f"{rod} is a rigid group: make nodes that follow it part of it with `rigid`"
            )

    def _frame_at(self, section: Floats, rod: int, arm: float) -> Frame:
        """A frame on a section, shape (9,)."""
        g1, g2 = section[3:6], section[6:9]
        normal = np.cross(g1, g2)
        rest = np.concatenate([section, normal / np.linalg.norm(normal)])
        return Frame(self.q.size, self._rigidity({rod}, arm), rest)

    def _rigidity(self, rods: set[int], arm: float) -> float:
        """Stiffness k of a frame that carries nodes of rods, N mm."""
        size = max(arm, *(float(self.rods[rod].radius) for rod in rods), 0.0)
        return RIGID * size * sum(self.rods[rod].constrained_stiffness for rod in rods)

    def _refuse_taken(self, rod: int, nodes: Nodes, components: slice, cure: str) -> None:
        """Raises ValueError if a node is held, or follows something."""
        for own in self.layout.unknowns(rod, nodes)[:, components]:
            node = (int(own[0]) - int(self.layout.first[rod])) // int(self.layout.block[rod])
            if self.supports.is_held[own].any() or self.supports.has_mean_of(own):
                raise ValueError(f"node {node} of rod {rod} is held: {cure} instead, or release it")
            if self.supports.follows(own).any():
                raise ValueError(
                    f"node {node} of rod {rod} is part of a joint or a rigid group already"
                )


def _vectors(unknowns: Ints) -> Ints:
    """Unknowns of nodes, shape (k, 9), by vector: shape (3, k, 3)."""
    return unknowns.reshape(-1, 3, 3).transpose(1, 0, 2)


def _axes(axis: Floats) -> Floats:
    """Unit vectors g1, g2, g3, shape (3, 3), with g3 along the axis; the global ones where that is z."""
    if not axis.any():
        raise ValueError(f"axis is {axis}: give a direction")
    g3 = axis / np.linalg.norm(axis)
    across = np.eye(3)[0] if abs(g3[0]) < 0.9 else np.eye(3)[1]
    g1 = across - (across @ g3) * g3
    g1 /= np.linalg.norm(g1)
    return np.array([g1, np.cross(g3, g1), g3])
