"""Reference cells: nodes in the order of basix (vertices, edges, faces, interior), facets, shape functions."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]

_HEX_EDGES = "01 02 04 13 15 23 26 37 45 46 57 67"
_HEX_FACES = "0123 0145 0246 1357 2367 4567"
_QUAD_EDGES = "01 02 13 23"
_TET_EDGES = "23 13 12 03 02 01"
_TET_FACES = "123 023 013 012"
_TRIANGLE_EDGES = "12 02 01"


def _numbers(text: str) -> list[list[int]]:
    return [[int(digit) for digit in word] for word in text.split()]


@dataclass(frozen=True)
class ReferenceCell:
    """A cell of degree 1 or 2.

    Attributes:
        name: Of the cell in UFL.
        degree: 1 or 2.
        points: Nodes in the reference cell, shape (num_nodes, dim).
        facets: Nodes of each facet, shape (num_facets, num_facet_nodes), in the order of the facet's own reference
            cell and such that (dx/du) x (dx/dv) points outward; vertices only if the cell has no facets.
    """

    name: str
    degree: int
    points: FloatArray
    facets: IntArray

    @property
    def num_nodes(self) -> int:
        return len(self.points)

    @property
    def is_simplex(self) -> bool:
        return self.name in ("tetrahedron", "triangle")

    def shape(self, at: FloatArray) -> FloatArray:
        """Values of the shape functions at points (n, dim), shape (n, num_nodes)."""
        return _powers(at, self._exponents, None) @ self._coefficients

    def gradient(self, at: FloatArray) -> FloatArray:
        """Gradients of the shape functions at points (n, dim), shape (n, dim, num_nodes)."""
        columns = [_powers(at, self._exponents, i) for i in range(at.shape[1])]
        return np.stack(columns, axis=1) @ self._coefficients

    @cached_property
    def _exponents(self) -> IntArray:
        dim = self.points.shape[1]
        every = np.stack(np.meshgrid(*[np.arange(self.degree + 1)] * dim), -1).reshape(-1, dim)
        return every[every.sum(axis=1) <= self.degree] if self.is_simplex else every

    @cached_property
    def _coefficients(self) -> FloatArray:
        return np.asarray(np.linalg.inv(_powers(self.points, self._exponents, None)))


def _powers(at: FloatArray, exponents: IntArray, derivative: int | None) -> FloatArray:
    """Monomials, or their derivatives by one coordinate, at points; shape (n, num_monomials)."""
    result: FloatArray = np.ones((len(at), len(exponents)))
    for i in range(at.shape[1]):
        power, x = exponents[None, :, i], at[:, i, None]
        if i == derivative:
            result = result * power * x ** np.maximum(power - 1, 0)
        else:
            result = result * x**power
    return result


def _with_midpoints(vertices: FloatArray, groups: list[list[int]]) -> FloatArray:
    return np.vstack([vertices, [vertices[group].mean(axis=0) for group in groups]])


def _facet_nodes(points: FloatArray, facets: list[list[int]], degree: int) -> IntArray:
    """Nodes of each facet in its own order, turned outward."""
    centre = points.mean(axis=0)
    rows = []
    for vertices in facets:
        a, b, c = points[vertices[:3]]
        outward = np.dot(np.cross(b - a, c - a), a - centre) > 0.0
        v = vertices if outward else [vertices[0], vertices[2], vertices[1], *vertices[3:]]
        corners = points[v]
        if degree == 2:
            edges = _numbers(_QUAD_EDGES if len(v) == 4 else _TRIANGLE_EDGES)
            inside = [list(range(4))] if len(v) == 4 else []
            corners = _with_midpoints(corners, edges + inside)
        distance = np.linalg.norm(points[None] - corners[:, None], axis=2)
        rows.append(distance.argmin(axis=1))
    return np.array(rows)


def _tensor(dim: int) -> FloatArray:
    return np.array([[(i >> k) & 1 for k in range(dim)] for i in range(2**dim)], dtype=float)


def _make(name: str, degree: int) -> ReferenceCell:
    groups: list[list[int]]
    faces: list[list[int]] = []
    if name == "quadrilateral":
        points, groups = _tensor(2), _numbers(_QUAD_EDGES) + [[0, 1, 2, 3]]
    elif name == "hexahedron":
        points, faces = _tensor(3), _numbers(_HEX_FACES)
        groups = _numbers(_HEX_EDGES) + faces + [list(range(8))]
    else:
        points, faces = np.vstack([np.zeros(3), np.eye(3)]), _numbers(_TET_FACES)
        groups = _numbers(_TET_EDGES)
    if degree == 2:
        points = _with_midpoints(points, groups)
    facets = _facet_nodes(points, faces, degree) if faces else np.empty((0, 0), dtype=np.int64)
    return ReferenceCell(name, degree, points, facets)


QUADS = {degree: _make("quadrilateral", degree) for degree in (1, 2)}
HEXAHEDRA = {degree: _make("hexahedron", degree) for degree in (1, 2)}
TETRAHEDRA = {degree: _make("tetrahedron", degree) for degree in (1, 2)}
SOLID_CELLS = {cell.num_nodes: cell for kind in (HEXAHEDRA, TETRAHEDRA) for cell in kind.values()}
QUAD_EDGES = np.array(_numbers(_QUAD_EDGES))
