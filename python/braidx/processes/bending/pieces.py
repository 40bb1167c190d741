"""A stretch of a yarn, or the core, among the unknowns of the bent rope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...bodies.coupling import follow_mean, follow_section
from ...meshing import Sweep
from ...system.constraints import Constraints, Floats, Ints
from .clamp import Clamp


@dataclass(frozen=True)
class Piece:
    """Nodes along a stretch, section by section.

    Attributes:
        positions: First unknowns of the positions of the nodes in each section, shape (num_sections, n): n = 1 for
            curves; of a mesh that was not swept one array per section.
        directors: Whether each node has two directors, whose unknowns follow those of its position.
        sweep: Of a solid.
    """

    positions: Ints | tuple[Ints, ...]
    directors: bool = False
    sweep: Sweep | None = None

    @property
    def is_solid(self) -> bool:
        """Whether sections have nodes all over."""
        return self.sweep is not None

    def centre_line(self, q: Floats) -> Floats:
        """Mean position of each section, shape (num_sections, 3), mm."""
        weights = None if self.sweep is None else self.sweep.weights
        component = np.arange(3)
        return np.array(
            [
                np.average(q[nodes[:, None] + component], axis=0, weights=weights)
                for nodes in self.positions
            ]
        )

    def sections(self, q: Floats) -> Floats:
        """Directors of each node of a beam, shape (num_sections, 2, 3)."""
        return q[np.asarray(self.positions) + np.arange(3, 9)].reshape(-1, 2, 3)

    def clamp(self, constraints: Constraints, section: int, clamp: Clamp, start: Floats) -> None:
        """Ends the piece in a clamp; sections of beams may turn there.

        Args:
            constraints: Are added to.
            section: 0 or -1.
            clamp: The clamp.
            start: All unknowns of the straight rope.
        """
        clamp.carry(constraints, self.positions[section], start)


def join(constraints: Constraints, values: Floats, before: Piece, after: Piece) -> None:
    """Makes one yarn of a curve and a solid that meet in a section.

    Args:
        constraints: Are added to.
        values: Their values, shape (num_unknowns,), filled in.
        before, after: The pieces; the last section of the one is the first of the other.
    """
    ends = [(before, before.positions[-1]), (after, after.positions[0])]
    (curve, (node,)), (solid, nodes) = sorted(ends, key=lambda end: end[0].is_solid)
    assert solid.sweep is not None
    face = nodes[:, None] + np.arange(3)
    if curve.directors:
        follow_section(constraints, values, face, solid.sweep.section, int(node))
    else:
        follow_mean(constraints, values, face, solid.sweep.weights, int(node))
