"""Canonical numbering of the nodes and elements of many curves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]


@dataclass(frozen=True)
class CurveLayout:
    """Curve by curve, along each curve: the numbering that every rank and every array shares.

    Elements of degree 2 have their middle node between their ends, so that a curve of n elements
    has n degree + 1 nodes in order of arc length.
    """

    degree: int
    curves: IntArray  # (num_curves + 1,) first node of each curve
    curve_elements: IntArray  # (num_curves + 1,) first element of each curve
    elements: IntArray  # (num_elements, degree + 1) nodes: first end, second end, middle

    @classmethod
    def from_node_counts(cls, counts: Sequence[int], degree: int) -> CurveLayout:
        """Number the curves that have `counts` nodes.

        Raises:
            ValueError: If the degree is not 1 or 2 or a count of nodes does not fit it.
        """
        if degree not in (1, 2):
            raise ValueError(f"degree is {degree}: line elements have degree 1 or 2")
        nodes = np.asarray(counts, dtype=np.int64)
        for curve, count in enumerate(nodes):
            if count <= degree or (count - 1) % degree:
                raise ValueError(
                    f"centre line {curve} has {count} nodes: give {degree} n + 1 nodes, n >= 1, "
                    f"for elements of degree {degree}"
                )
        curves = np.concatenate([[0], np.cumsum(nodes)])
        curve_elements = np.concatenate([[0], np.cumsum((nodes - 1) // degree)])
        # First end of an element: degree times its number, plus one per curve before it.
        element_curve = np.repeat(np.arange(len(nodes)), np.diff(curve_elements))
        first = degree * np.arange(curve_elements[-1]) + element_curve
        ends = [first, first + degree] + ([first + 1] if degree == 2 else [])
        return cls(degree, curves, curve_elements, np.stack(ends, axis=1))

    @property
    def num_curves(self) -> int:
        return len(self.curves) - 1

    @property
    def num_nodes(self) -> int:
        return int(self.curves[-1])

    @property
    def num_elements(self) -> int:
        return len(self.elements)

    def per_element(self, values: npt.ArrayLike, name: str) -> FloatArray:
        """Spread one value, one per curve or one per element over the elements, shape
        (num_elements,).

        Raises:
            ValueError: If the shape is none of these or a value is not finite.
        """
        array = np.asarray(values, dtype=np.float64)
        if not np.all(np.isfinite(array)):
            raise ValueError(f"{name} is not finite")
        if array.shape == ():
            return np.full(self.num_elements, array)
        if array.shape == (self.num_curves,):
            return np.repeat(array, np.diff(self.curve_elements))
        if array.shape == (self.num_elements,):
            return array.copy()
        raise ValueError(
            f"{name} has shape {array.shape}: give one value, one per curve ({self.num_curves},) "
            f"or one per element ({self.num_elements},)"
        )

    def chunk(self, rank: int, size: int) -> tuple[slice, slice]:
        """Elements and nodes that rank `rank` of `size` supplies.

        Whole curves while there are enough of them, so that ranks share no node; else curves are
        cut.
        """
        cuts = np.linspace(0, self.num_elements, size + 1).astype(np.int64)
        if self.num_curves >= size:
            cuts = self.curve_elements[_nearest(self.curve_elements, cuts)]
        node_cuts = self.elements[np.minimum(cuts, self.num_elements - 1), 0]
        node_cuts[cuts == self.num_elements] = self.num_nodes
        return (
            slice(int(cuts[rank]), int(cuts[rank + 1])),
            slice(int(node_cuts[rank]), int(node_cuts[rank + 1])),
        )


def _nearest(starts: IntArray, cuts: IntArray) -> IntArray:
    """Index of the start nearest to each cut; both ascending."""
    return np.abs(starts[:, None] - cuts[None, :]).argmin(axis=0)
