"""What holds, moves and loads rods, and what rubs: between two calls of `solve` or `run`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ..system.terms import Floats, Ints
from .friction import Friction
from .given import numbers
from .layout import Layout, Nodes
from .loads import Loads
from .state import ALL
from .supports import Motion, Supports


class Boundary:
    """Supports, motions, loads and friction of rods. See Rods."""

    q: Floats
    layout: Layout
    supports: Supports
    loads: Loads
    _friction: Friction

    # What is held and moved

    def hold(self, rod: int, nodes: Nodes = ALL, components: Any = ALL) -> None:
        """Components of nodes stay where they are: 0 to 2 the position, 3 to 5 and 6 to 8 the directors.

        Raises:
            ValueError: If the rod is a solid and a node is none of its ends, or a node is part of a group or a joint.
        """
        self.supports.hold(self._free_to_hold(rod, nodes, components).ravel(), self.q)

    def pin(self, rod: int, nodes: Nodes) -> None:
        """Positions stay where they are; sections may turn."""
        self.hold(rod, nodes, slice(0, 3))

    def clamp(self, rod: int, nodes: Nodes) -> None:
        """Positions and sections stay as they are."""
        self.hold(rod, nodes)

    def release(self, rod: int, nodes: Nodes, components: Any = ALL) -> None:
        """What was held is free from now on."""
        self.supports.release(self.layout.unknowns(rod, nodes)[:, components].ravel())

    def hold_mean(self, places: Sequence[tuple[int, int]], components: Any = ALL) -> int:
        """The mean position of nodes, given as (rod, node), or some components of it, stays where it is.

        Returns:
            Number of the group.
        """
        positions = [self._free_to_hold(rod, node, slice(3))[0, components] for rod, node in places]
        return self.supports.hold_mean(np.array(positions), self.q)

    def move(
        self,
        rod: int,
        nodes: Nodes,
        by: npt.ArrayLike = (0.0, 0.0, 0.0),
        turn: npt.ArrayLike = (0.0, 0.0, 0.0),
        about: npt.ArrayLike | None = None,
    ) -> None:
        """Held nodes are turned by a rotation vector (radians) about a point or each about itself, then moved, mm."""
        unknowns = self.layout.unknowns(rod, nodes)
        centre = None if about is None else numbers("about", about, 3)
        self.supports.move(Motion(unknowns, numbers("turn", turn, 3), centre, numbers("by", by, 3)))

    def move_mean(self, group: int, by: npt.ArrayLike) -> None:
        """The mean position of a group moves, mm; of a group of some components, by as many."""
        self.supports.shift_mean(group, numbers("by", by, np.size(by)))

    def _free_to_hold(self, rod: int, nodes: Nodes, components: Any) -> Ints:
        """Unknowns of components of nodes, shape (n, num_components)."""
        unknowns = self.layout.unknowns_to_hold(rod, nodes)[:, components]
        following = self.supports.follows(unknowns).any(axis=1)
        if following.any():
            own = np.arange(1 if rod >= len(self.layout.first) else self.layout.num_nodes[rod])
            raise ValueError(
                f"node {np.atleast_1d(own[nodes])[following][0]} of rod {rod} follows a rigid group or a joint: hold "
                "what it follows"
            )
        return unknowns

    # What pulls

    def force(self, rod: int, nodes: Nodes, force: npt.ArrayLike) -> None:
        """Dead force on each of the nodes from the next equilibria on, N; it replaces the one before."""
        self.loads.force(self.layout.unknowns(rod, nodes), numbers("force", force, 3))

    def line_load(self, rod: int, load: npt.ArrayLike) -> None:
        """Dead load per length at rest along a rod, N/mm, shape (3,); it replaces the one before."""
        self.loads.line(self.layout.unknowns(rod, ALL), numbers("load", load, 3))

    def couple(self, rod: int, node: int, couple: npt.ArrayLike) -> None:
        """Couple on the section of a beam, its direction fixed in space, N mm; it replaces the one before.

        Raises:
            ValueError: If the rod is a cable, which has no sections.
        """
        self.loads.couple(self.layout.unknowns(rod, node), numbers("couple", couple, 3), rod)

    # What rubs

    def friction_between(self, first: int, second: int, coefficient: float) -> None:
        """Coefficient of friction of two rods from now on, or of a rod with itself.

        Rigid surface k goes by -1 - k, as in `contacts`; those that braidx_engine made have one coefficient together.

        Raises:
            IndexError: If there is no such rod or rigid surface.
        """
        self._friction.between(first, second, coefficient)

    def friction_of(self, body: int, coefficient: float) -> None:
        """Coefficient of friction of a rod or a rigid surface with all that it touches, from now on."""
        self._friction.of(body, coefficient)
