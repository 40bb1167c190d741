"""First guesses that would lead to a wrong equilibrium."""

from __future__ import annotations

import numpy as np

from ..solver.trial import Diverged
from ..system.terms import Floats
from .layout import Layout

# Of the distance of two nodes, what has to be left of it along the line where they were. Beams squeezed by more than
# that may find no way back.
FOLDED = 0.8


def refuse_folds(layout: Layout, before: Floats, guess: Floats) -> None:
    """Held nodes that move far in one increment fold the elements beside them, which may stay folded: an equilibrium,
    but not the one that the motion leads to.

    Args:
        before, guess: Unknowns, shape (num_unknowns,).
    Raises:
        Diverged: If two neighbours are folded towards each other.
    """
    for rod in range(len(layout.first)):
        positions = layout.unknowns(rod, slice(None))[:, :3]
        old, new = np.diff(before[positions], axis=0), np.diff(guess[positions], axis=0)
        left = np.einsum("ni,ni->n", new, old) / np.einsum("ni,ni->n", old, old)
        if left.min() < FOLDED:
            node = int(left.argmin())
            raise Diverged(
                f"the motion would fold rod {rod} between its nodes {node} and {node + 1}", 0, 0
            )
