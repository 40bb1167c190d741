"""Meshes of sections: quadrilaterals in the plane of two directors."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .beam_section import BeamSection
from .reference import QUAD_EDGES, QUADS, FloatArray, IntArray, ReferenceCell

SMOOTH = 50.0  # degrees between facets up to which contact takes them for one smooth surface


@dataclass(frozen=True)
class SectionMesh:
    """Mesh of a section.

    Attributes:
        points: Coordinates (xi1, xi2) of the nodes about the centre line, shape (num_nodes, 2), mm.
        quads: Nodes of each quadrilateral in the order of basix, shape (num_quads, 4 or 9).
        outer: (quad, local edge) of the outer boundary, shape (num_outer, 2).
        inner: Likewise of the inner boundary of a hollow section, shape (num_inner, 2).
    """

    points: FloatArray
    quads: IntArray
    outer: IntArray
    inner: IntArray

    @property
    def cell(self) -> ReferenceCell:
        return QUADS[self.degree]

    @property
    def degree(self) -> int:
        return 1 if self.quads.shape[1] == 4 else 2

    @property
    def outer_radius(self) -> float:
        """Distance from the centre line of the farthest nodes, mm."""
        return float(np.linalg.norm(self.points, axis=1).max())

    @property
    def is_round(self) -> bool:
        """Whether the boundary stands for a circle: vertices on one, and edges that meet at less than 50 degrees."""
        quad, edge = self.outer.T
        vertices = self.points[self.quads[quad[:, None], QUAD_EDGES[edge]]]
        distance = np.linalg.norm(vertices, axis=-1)
        return len(quad) * SMOOTH > 360.0 and bool(np.ptp(distance) < 1e-6 * self.outer_radius)

    def moments(self) -> tuple[float, float, float]:
        """Area (mm^2) and the integrals of xi1^2 and xi2^2 (mm^4) of the mesh: of the polygon, not of the circle."""
        shape, measure = self._gauss()
        x = np.einsum("pn,qni->qpi", shape, self.points[self.quads])
        first, second = (float(np.sum(measure * x[..., i] ** 2)) for i in range(2))
        return float(measure.sum()), first, second

    def weights(self) -> FloatArray:
        """Integral of each node's shape function, shape (num_nodes,), mm^2; their sum is the area."""
        shape, measure = self._gauss()
        result = np.zeros(len(self.points))
        np.add.at(result, self.quads, measure @ shape)
        return result

    def _gauss(self) -> tuple[FloatArray, FloatArray]:
        """Shape functions at Gauss points (num_points, num_quad_nodes), measure (num_quads, num_points)."""
        abscissae, weights = np.polynomial.legendre.leggauss(4)
        at = np.stack(np.meshgrid(abscissae, abscissae), axis=-1).reshape(-1, 2) / 2.0 + 0.5
        jacobian = np.einsum("pdn,qni->qpid", self.cell.gradient(at), self.points[self.quads])
        return self.cell.shape(at), np.linalg.det(jacobian) * np.outer(weights, weights).ravel() / 4

    def beam_section(self, torsion_constant: float | None = None) -> BeamSection:
        """Section of a beam with the area and inertias of the mesh.

        Args:
            torsion_constant: J, mm^4; by default the polar moment of inertia, exact where the section does not warp.
        """
        area, first, second = self.moments()
        torsion = first + second if torsion_constant is None else torsion_constant
        return BeamSection(area, first, second, torsion, area)

    def scaled_to(self, area: float) -> SectionMesh:
        """The same mesh, enlarged to an area in mm^2."""
        return replace(self, points=self.points * np.sqrt(area / self.moments()[0]))
