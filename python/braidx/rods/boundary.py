"""What holds, moves and loads rods, and what rubs: between two calls of `solve` or `run`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ..system.terms import Floats, Ints
from .friction import Friction
from .given import numbers
from .inside import Where, unknowns_inside, unknowns_on_plane
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
        of_position = np.arange(3)[components]
        positions = [self._free_to_hold(rod, node, of_position)[0] for rod, node in places]
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

    def hold_inside(self, rod: int, where: Where, components: Any = ALL) -> None:
        """Components 0 to 2 of the positions of nodes of a solid stay where they are.

        Ends of solids stay plane: one with chosen nodes is held as a whole, and does not stretch in these components.

        Args:
            where: Two corners of a box, shape (2, 3), mm, or what tells of positions at rest, shape (n, 3), whether
                they are chosen, shape (n,).
        Raises:
            ValueError: If the rod is no solid, no node is there, or its end is part of a group or a joint.
        """
        chosen = np.atleast_1d(np.arange(3)[components])
        self._hold_all(unknowns_inside(self.layout, rod, where, chosen), f"rod {rod}")

    def plane_strain(self, rod: int, axis: int = 2) -> None:
        """No node of a solid moves along x, y or z (axis 0, 1 or 2)."""
        if axis not in (0, 1, 2):
            raise ValueError(f"axis is {axis}: give 0, 1 or 2 for no strain along x, y or z")
        self.hold_inside(rod, lambda x: np.full(len(x), True), [axis])

    def symmetry(self, axis: int, at: float = 0.0) -> None:
        """Rods go on beyond a plane as their mirror images: what ends at it, or lies in it, stays in it.

        Forces on what lies in the plane are half of those on the whole. Contact does not see the images: where rods
        would touch their own, a rigid Plane there, without friction, is the same.

        Args:
            axis: 0, 1 or 2: the plane is normal to x, y or z.
            at: Its place on that axis, mm.
        Raises:
            ValueError: If no node is on it, or a director of a beam is neither in it nor normal to it.
        """
        plane = unknowns_on_plane(self.layout, self.q, axis, at)
        self._hold_all(plane, f"a rod on the plane at {at} mm")

    def _hold_all(self, unknowns: Ints, what: str) -> None:
        if self.supports.follows(unknowns).any():
            raise ValueError(
                f"a node of {what} follows a rigid group or a joint: hold what it follows"
            )
        self.supports.hold(unknowns, self.q)

    def _free_to_hold(self, rod: int, nodes: Nodes, components: Any) -> Ints:
        """Unknowns of components of nodes, shape (n, num_components)."""
        whole = self.layout.unknowns_to_hold(rod, nodes)
        unknowns = whole[:, components].reshape(len(whole), -1)
        following = self.supports.follows(unknowns).any(axis=1)
        if following.any():
            own = np.arange(1 if rod >= len(self.layout.first) else self.layout.num_nodes[rod])
            raise ValueError(
                f"node {np.atleast_1d(own[nodes])[following][0]} of rod {rod} follows a rigid group or a joint: hold "
                "what it follows"
            )
        return unknowns

    # What pulls

    def force(self, rod: int, nodes: Nodes, force: npt.ArrayLike, at_once: bool = False) -> None:
        """Dead force on each of the nodes from the next equilibria on, N; it replaces the one before.

        Args:
            at_once: Whether it acts in full from the first increment on; loads grow evenly over all by default.
        """
        self.loads.force(self.layout.unknowns(rod, nodes), numbers("force", force, 3), at_once)

    def line_load(self, rod: int, load: npt.ArrayLike, at_once: bool = False) -> None:
        """Dead load per length at rest along a rod, N/mm, shape (3,); it replaces the one before."""
        self.loads.line(self.layout.unknowns(rod, ALL), numbers("load", load, 3), at_once)

    def couple(self, rod: int, node: int, couple: npt.ArrayLike, at_once: bool = False) -> None:
        """Couple on the section of a beam, its direction fixed in space, N mm; it replaces the one before.

        Raises:
            ValueError: If the rod is a cable, which has no sections.
        """
        first = self._section(rod, node, "couples act on sections")[3]
        self.loads.couples.ask_for(int(first), numbers("couple", couple, 3), at_once)

    def follower_force(
        self, rod: int, node: int, force: npt.ArrayLike, at_once: bool = False
    ) -> None:
        """Force on a section that turns with it, N; it replaces the one before.

        Args:
            force: Along the directors g1, g2 and the section's normal g1 x g2.
        Raises:
            ValueError: If the rod is a cable, which has no sections.
        """
        first = self._section(rod, node, "forces follow sections")[0]
        self.loads.followers.ask_for(int(first), numbers("force", force, 3), at_once)

    def pressure(
        self,
        rod: int,
        load: float,
        axis: npt.ArrayLike = (0.0, 0.0, 1.0),
        at_once: bool = False,
    ) -> None:
        """Load per present length to one side of a rod: along axis x tangent, N/mm; it replaces the one before.

        Of a rod in a plane with this normal it stays normal to the rod however that bends: to the left of the way along
        the line, as seen from where the axis points to.
        """
        self.layout.unknowns(rod, 0)
        if rod >= len(self.layout.first):
            raise ValueError(f"{rod} is a rigid group: pressure acts along rods")
        normal = numbers("axis", axis, 3)
        if not normal.any():
            raise ValueError(f"axis is {normal}: give a direction")
        value = float(numbers("load", load)) * normal / np.linalg.norm(normal)
        self.loads.pressures.ask_for(rod, value, at_once)

    def _section(self, rod: int, node: int, why: str) -> Ints:
        """Unknowns of a node with directors, shape (block,)."""
        unknowns = self.layout.unknowns(rod, node)
        if unknowns.shape[1] < 9:
            raise ValueError(f"rod {rod} is a cable: {why}, give a Beam or a Solid")
        return unknowns[0]

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
