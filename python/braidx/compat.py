"""What differs between releases of DOLFINx; decided by feature, never by version string."""

from collections.abc import Callable
from typing import Any

import numpy as np
from dolfinx import graph


def keep_cells(num_cells: int, rank: int) -> Callable[..., Any]:
    """Partitioner for `create_mesh` that leaves every cell on the rank that supplies it.

    DOLFINx calls it from C++ with arguments that depend on the release; none is needed.

    Args:
        num_cells: Number of cells supplied by this rank.
        rank: This rank.
    """

    def partition(*_: Any) -> Any:
        destinations = np.full(num_cells, rank, dtype=np.int32)
        offsets = np.arange(num_cells + 1, dtype=np.int32)
        adjacency = graph.adjacencylist(destinations, offsets)
        return getattr(adjacency, "_cpp_object", adjacency)

    return partition
