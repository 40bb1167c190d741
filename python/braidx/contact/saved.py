"""Contact elements that come from a file."""

from __future__ import annotations

from typing import Any

import braidx_engine as engine
import numpy as np


def own_pairs(arrays: dict[str, np.ndarray], pairing: Any) -> dict[str, np.ndarray]:
    """Of contact elements of all processes, see Contact.arrays, those that `pairing` makes this one's."""
    a, b = arrays["tubes"].astype(np.int64).T
    # States saved by earlier versions know no facets, no ends, no multipliers and no frames.
    older: dict[str, np.ndarray] = {
        "facet": np.full((a.size, 2), -1, np.int32),
        "round": np.zeros((a.size, 2)),
        "multiplier": np.zeros(a.size),
        "frame": np.full(a.size, -1, np.int64),
        "in_frame": np.zeros((a.size, 3)),
    }
    arrays = {**older, **arrays}
    swapped = np.all(arrays["facet"] >= 0, axis=1) & (b < a)
    first, second = np.where(swapped, (b, a), (a, b))
    own = engine.is_own(pairing, first, np.where(second < 0, -1 - second, second))
    return {name: part[own] for name, part in arrays.items()}
