"""What contact sees past the ends of a periodic sample: nodes that repeat those at its other end."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from ..system.terms import Floats, Ints


@dataclass(frozen=True)
class Beyond:
    """Unknowns as contact numbers them: tube by tube, with the nodes past both ends.

    A node past the last one is the image of one near the first: it lies further along the axis by the distance of the
    two end nodes.

    Attributes:
        spread: Matrix that makes them from the unknowns of the tubes, shape (num_seen, num_unknowns).
        first_unknown: Numbers of the first unknown of each tube's first node, shape (num_tubes,).
    """

    spread: sp.csr_matrix
    first_unknown: Ints

    @staticmethod
    def of(first_unknown: Ints, num_nodes: Ints, block: Ints, beyond: int) -> Beyond:
        """Extends tubes whose unknowns follow each other along z.

        Args:
            first_unknown, num_nodes, block: Of each tube, shape (num_tubes,).
            beyond: Nodes past either end; fewer than a tube has.
        """
        rows, cols, signs, firsts = [], [], [], []
        seen = 0
        for first, count, width in zip(first_unknown, num_nodes, block, strict=True):
            node = np.arange(-beyond, count + beyond)
            period = np.where(node < 0, -1, np.where(node >= count, 1, 0))
            own = (first + width * (node - (count - 1) * period))[:, None] + np.arange(width)
            number = seen + np.arange(own.size).reshape(own.shape)
            last, moved = first + width * (count - 1), period != 0
            for columns, sign in ((last + 2, period[moved]), (first + 2, -period[moved])):
                rows.append(number[moved, 2])
                cols.append(np.full(moved.sum(), columns))
                signs.append(sign)
            rows.append(number.ravel())
            cols.append(own.ravel())
            signs.append(np.ones(own.size))
            firsts.append(seen + width * beyond)
            seen += own.size
        entries = np.concatenate(signs).astype(float), (np.concatenate(rows), np.concatenate(cols))
        size = int(np.max(first_unknown + num_nodes * block))
        return Beyond(sp.csr_matrix(entries, shape=(seen, size)), np.array(firsts, dtype=np.int64))

    def see(self, q: Floats) -> Floats:
        """Unknowns in the numbers of contact, shape (num_seen,)."""
        seen: Floats = self.spread @ q[: self.spread.shape[1]]
        return seen

    def give_back(self, seen: Floats, residual: Floats) -> None:
        """Adds forces on what contact sees, shape (num_seen,), to those on the unknowns."""
        residual[: self.spread.shape[1]] += self.spread.T @ seen
