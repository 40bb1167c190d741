"""Heat sources: the work of friction at the crossings, spread over the cells of a cylinder."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]


def crossing_powers(work: FloatArray, frequency: float) -> FloatArray:
    """Mean power of each crossing over many cycles, W.

    Args:
        work: Work of friction per bending cycle, shape (k,), mJ.
        frequency: Cycles per second, Hz.
    """
    return 1e-3 * frequency * np.asarray(work, dtype=float)


def spread(
    radial_edges: FloatArray,
    axial_edges: FloatArray,
    positions: FloatArray,
    powers: FloatArray,
    reach: float,
) -> FloatArray:
    """Power density of sources about the z-axis, shape (radial cells, axial cells), W/mm^3.

    Each source fills a ring of square section, `reach` to either side of its place, evenly as far
    as the ring lies in the body; the total power is kept exactly. The mean is taken round the
    circumference: a body of revolution knows no angle.

    Args:
        radial_edges: Borders of the cells, shape (radial cells + 1,), mm, ascending.
        axial_edges: The same along the axis, mm.
        positions: Of the sources in the straight rope, shape (k, 3), mm.
        powers: Of the sources, shape (k,), W.
        reach: Half width of a ring, mm; the radius of the yarns.
    Raises:
        ValueError: If a source lies outside the body by more than `reach`.
    """
    distance = np.hypot(positions[:, 0], positions[:, 1])
    # Shares of the ring in each row and column of cells; radially by area.
    rows = _overlap(radial_edges**2, np.maximum(distance - reach, 0) ** 2, (distance + reach) ** 2)
    columns = _overlap(axial_edges, positions[:, 2] - reach, positions[:, 2] + reach)
    for name, shares in (("radially", rows), ("axially", columns)):
        outside = np.flatnonzero(shares.sum(axis=1) <= 0.0)
        if len(outside):
            place = positions[outside[0]]
            raise ValueError(
                f"heat source at x, y, z = {place[0]:.3g}, {place[1]:.3g}, {place[2]:.3g} mm lies"
                f" {name} outside the body; make the body large enough for the rope."
            )
    rows /= rows.sum(axis=1, keepdims=True)
    columns /= columns.sum(axis=1, keepdims=True)
    power = np.einsum("k,ki,kj->ij", powers, rows, columns)
    density: FloatArray = power / cell_volumes(radial_edges, axial_edges)
    return density


def cell_volumes(radial_edges: FloatArray, axial_edges: FloatArray) -> FloatArray:
    """Volumes of the rings that the cells stand for, shape (radial cells, axial cells), mm^3."""
    return np.pi * np.outer(np.diff(radial_edges**2), np.diff(axial_edges))


def _overlap(edges: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray:
    """Length that intervals low ... high share with each cell, shape (k, cells)."""
    start = np.maximum(edges[:-1], low[:, None])
    end = np.minimum(edges[1:], high[:, None])
    return np.maximum(end - start, 0.0)
