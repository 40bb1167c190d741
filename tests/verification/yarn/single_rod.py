"""Static equilibrium of one clamped rod under end loads, as the reference cases need it."""

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np
from mpi4py import MPI
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import splu

from braidx.bodies import BeamBody, BeamSection, CurveBody, YarnMaterial

BLOCK = 9
POSITION, DIRECTOR_1, DIRECTOR_2 = slice(0, 3), slice(3, 6), slice(6, 9)


class EndLoad(Protocol):
    """Load on the last node, derived from a potential so that the tangent is symmetric."""

    def __call__(self, node: np.ndarray, factor: float) -> tuple[np.ndarray, np.ndarray]:
        """Force on the unknowns of the node, shape (9,), and its derivative, shape (9, 9)."""


def dead_force(force: Sequence[float]) -> EndLoad:
    """A force of constant direction, N."""

    def load(node: np.ndarray, factor: float) -> tuple[np.ndarray, np.ndarray]:
        total = np.zeros(BLOCK)
        total[POSITION] = factor * np.asarray(force)
        return total, np.zeros((BLOCK, BLOCK))

    return load


def couple_about_z(moment: float, director: slice = DIRECTOR_1) -> EndLoad:
    """A couple about z, N mm, that works on the angle of a director in the plane (x, y).

    Its potential is -M atan2(g_y, g_x), so that it turns with the section and does no work on its
    stretch.
    """

    def load(node: np.ndarray, factor: float) -> tuple[np.ndarray, np.ndarray]:
        a, b, _ = node[director]
        square = a * a + b * b
        total, rate = np.zeros(BLOCK), np.zeros((BLOCK, BLOCK))
        total[director] = factor * moment * np.array([-b, a, 0.0]) / square
        plane = slice(director.start, director.start + 2)
        rate[plane, plane] = (
            factor * moment * np.array([[2 * a * b, b * b - a * a], [b * b - a * a, -2 * a * b]])
        ) / square**2
        return total, rate

    return load


def straight_rod(
    length: float, num_elements: int, degree: int, section: BeamSection, material: YarnMaterial, **k
) -> BeamBody:
    """A rod along x with directors along y and z."""
    x = np.linspace(0.0, length, num_elements * degree + 1)
    line = np.stack([x, 0 * x, 0 * x], axis=1)
    directors = np.tile([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], (len(x), 1, 1))
    return BeamBody(
        MPI.COMM_SELF,
        [line],
        section=section,
        material=material,
        directors=[directors],
        degree=degree,
        **k,
    )


def tangent_matrix(body: CurveBody) -> csc_matrix:
    """Tangent of the body's current state."""
    rows, columns = body.tangent_pattern()
    size = (body.num_unknowns, body.num_unknowns)
    return coo_matrix((body.tangent_values(), (rows, columns)), shape=size).tocsc()


def equilibrium(
    body: BeamBody,
    load: EndLoad,
    steps: int | Sequence[float] = 1,
    fixed: np.ndarray | None = None,
    start: np.ndarray | None = None,
    observe: Callable[[np.ndarray], None] = lambda q: None,
    max_iterations: int = 60,
) -> np.ndarray:
    """Newton's method at growing load factors, from the state at rest.

    Args:
        body: One curve.
        load: Load on its last node.
        steps: Number of equal steps, or the load factors.
        fixed: Mask of the unknowns that keep their start value, shape (num_nodes, 9); the first
            node by default.
        start: First state, shape (num_nodes, 9); the state at rest by default.
        observe: Called with the state after each step.
    Returns:
        Equilibrium at the last factor, shape (num_nodes, 9).
    Raises:
        RuntimeError: If a step takes more than `max_iterations`.
    """
    q = np.array(body.rest if start is None else start)
    if fixed is None:
        fixed = np.zeros(q.shape, dtype=bool)
        fixed[0] = True
    free = np.flatnonzero(~fixed.ravel())
    factors = np.arange(1, steps + 1) / steps if isinstance(steps, int) else steps
    size = np.ptp(body.rest[:, POSITION], axis=0).max()
    for factor in factors:
        for iteration in range(max_iterations):
            body.set_state(q)
            force, rate = load(q[-1], factor)
            residual = body.residual().copy()
            residual[-BLOCK:] -= force
            matrix = tangent_matrix(body).tolil()
            matrix[-BLOCK:, -BLOCK:] -= rate
            increment = np.zeros(q.size)
            increment[free] = -splu(matrix.tocsc()[free][:, free]).solve(residual[free])
            q += increment.reshape(q.shape)
            if np.abs(increment).max() < 1e-8 * size:
                break
        else:
            raise RuntimeError(f"no equilibrium at load factor {factor}")
        observe(q)
    body.set_state(q)
    return q
