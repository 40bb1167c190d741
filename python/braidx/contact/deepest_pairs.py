"""Which bodies penetrate each other most."""

from __future__ import annotations

import numpy as np
from mpi4py import MPI


def deepest_pairs(
    results: dict[str, np.ndarray], comm: MPI.Comm, count: int
) -> list[tuple[int, int]]:
    """Pairs of tubes with the deepest penetrations of all processes, deepest first; at most `count`.

    Args:
        results: Of the contact elements of this process, see Contact.results.
    """
    first = np.argsort(results["gap"])[: 20 * count]
    mine = [(float(results["gap"][i]), *map(int, results["tubes"][i])) for i in first]
    ranked = sorted(sum(comm.allgather(mine), []))
    return list(dict.fromkeys((a, b) for gap, a, b in ranked if gap < 0))[:count]
