"""The yarns of a rope in their start configuration: helices around helices (paper 1, 3.4.1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.crossings import Crossings

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Rope:
    """A rope along z from 0 to length; all nodes of all lines are uniform in z."""

    centre_lines: tuple[Array, ...]  # per yarn (num_nodes, 3), mm
    radius: Array  # (num_yarns,), mm
    strand: NDArray[np.int64]  # (num_yarns,), strand of each yarn
    layer: NDArray[np.int64]  # (num_strands,), layer (direction) of each strand
    strand_lines: tuple[Array, ...]  # per strand (num_nodes, 3), mm
    crossings: Crossings
    length: float  # mm
    pitch: float  # mm

    @property
    def num_yarns(self) -> int:
        return len(self.centre_lines)

    @property
    def num_strands(self) -> int:
        return len(self.strand_lines)

    @property
    def crown(self) -> float:
        """Where the rope is bent, z of its middle, mm."""
        return self.length / 2.0

    @property
    def num_yarn_crossings(self) -> int:
        """Crossings of a yarn with a yarn, in all crossings of their strands."""
        yarns = np.bincount(self.strand, minlength=self.num_strands)
        return int(yarns[self.crossings.strand_a] @ yarns[self.crossings.strand_b])
