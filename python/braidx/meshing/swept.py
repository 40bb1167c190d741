"""Parts that were swept along a line."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .reference import FloatArray, IntArray


@dataclass(frozen=True)
class Sweep:
    """A part made by sweeping a section along a line: node = centre + xi1 g1 + xi2 g2.

    Attributes:
        layers: Nodes of each layer, shape (num_layers, nodes_per_layer); degree 2 has layers at half elements too.
        section: Coordinates (xi1, xi2) of the nodes of a layer, shape (nodes_per_layer, 2), mm.
        line: Centre of each layer, shape (num_layers, 3), mm.
        directors: g1, g2 of each layer, shape (num_layers, 2, 3).
        cells: Cells between two layers, shape (num_elements, cells_per_element).
        weights: Area that belongs to each node of a layer, shape (nodes_per_layer,), mm^2.
    """

    layers: IntArray
    section: FloatArray
    line: FloatArray
    directors: FloatArray
    cells: IntArray
    weights: FloatArray

    @property
    def area(self) -> float:
        """Of the section's mesh, mm^2."""
        return float(self.weights.sum())

    def moved(self, nodes: int, cells: int) -> Sweep:
        """The same sweep in a mesh that has this many nodes and cells before it."""
        return replace(self, layers=self.layers + nodes, cells=self.cells + cells)
