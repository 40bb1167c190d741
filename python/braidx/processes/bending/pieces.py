"""A stretch of a yarn, or the core, among the unknowns of the bent rope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...system.constraints import Constraints, Floats, Ints
from .clamp import Clamp


@dataclass(frozen=True)
class Piece:
    """Nodes along a stretch, section by section.

    Attributes:
        positions: First unknowns of the positions of the nodes in each section, shape (num_sections, n): n = 1 for
            curves.
        directors: Whether each node has two directors, whose unknowns follow those of its position.
        first: Node of the yarn's line at the first section.
    """

    positions: Ints
    directors: bool
    first: int = 0

    @property
    def is_solid(self) -> bool:
        """Whether sections have nodes all over."""
        return self.positions.shape[1] > 1

    def centre_line(self, q: Floats) -> Floats:
        """Mean position of the nodes of each section, shape (num_sections, 3), mm."""
        line: Floats = q[self.positions[:, :, None] + np.arange(3)].mean(axis=1)
        return line

    def sections(self, q: Floats) -> Floats:
        """Directors of each node of a beam, shape (num_sections, 2, 3)."""
        return q[self.positions + np.arange(3, 9)].reshape(-1, 2, 3)

    def clamp(self, constraints: Constraints, section: int, clamp: Clamp, start: Floats) -> None:
        """Ends the piece in a clamp; sections of beams may turn there.

        Args:
            constraints: Are added to.
            section: 0 or -1.
            clamp: The clamp.
            start: All unknowns of the straight rope.
        """
        nodes = self.positions[section]
        across = start[nodes[:, None] + np.arange(2)]
        clamp.carry(constraints, nodes, across)


def join(
    constraints: Constraints, values: Floats, before: Piece, after: Piece, start: Floats
) -> None:
    """Makes one yarn of a curve and a solid that meet in a section.

    Args:
        constraints: Are added to.
        values: Their values, shape (num_unknowns,), filled in.
        before, after: The pieces; the last section of the one is the first of the other.
        start: All unknowns of the straight rope.
    """
    ends = [(before, before.positions[-1]), (after, after.positions[0])]
    (curve, (node,)), (_, face) = sorted(ends, key=lambda end: end[0].is_solid)
    if curve.directors:
        follow_section(constraints, face, int(node), start)
    else:
        follow_mean(constraints, values, face, int(node), start)


def follow_section(constraints: Constraints, nodes: Ints, beam_node: int, start: Floats) -> None:
    """The face of a solid follows the section of a beam, x = x0 + xi1 g1 + xi2 g2, exactly.

    Args:
        constraints: Are added to.
        nodes: First unknowns of the face's nodes, shape (n,).
        beam_node: First unknown of the beam's node.
        start: All unknowns of the straight rope, in which the face lies in the section's plane.
    """
    component = np.arange(3)
    centre = start[beam_node + component]
    directors = start[beam_node + 3 + np.arange(6)].reshape(2, 3)
    arms = start[nodes[:, None] + component] - centre
    section = arms @ np.linalg.pinv(directors)
    leaders = beam_node + 3 * np.arange(3)[None, :] + component[:, None]
    of = np.broadcast_to(leaders, (len(nodes), 3, 3)).reshape(-1, 3)
    factors = np.column_stack([np.ones(len(nodes)), section])
    constraints.combine_each(
        (nodes[:, None] + component).ravel(), of, np.repeat(factors, 3, axis=0)
    )


def follow_mean(
    constraints: Constraints, values: Floats, nodes: Ints, cable_node: int, start: Floats
) -> None:
    """The end of a cable is at the mean position of a solid's face, which is free to turn."""
    component = np.arange(3)
    of = nodes[None, :] + component[:, None]
    cable = cable_node + component
    constraints.combine_each(cable, of, np.full(of.shape, 1.0 / len(nodes)))
    values[cable] = start[cable] - start[of].mean(axis=1)
