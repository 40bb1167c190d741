"""Equations between unknowns, rows q = values, as constraints: each is solved for one of its unknowns."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy.linalg as la

from .constraints import Constraints, Floats, Ints

NEAR = 1e-9  # what is left of a row of length 1 by the rows before it: nothing


class Dependent(ValueError):
    """An equation follows from, or contradicts, constraints and equations before it.

    Attributes:
        row: Its number.
    """

    def __init__(self, row: int) -> None:
        super().__init__(
            f"equation {row} says nothing new: the ones before give its left-hand side"
        )
        self.row = row


def impose(
    constraints: Constraints,
    constraint_values: Floats,
    unknowns: Ints,
    rows: Floats,
    values: Floats,
) -> None:
    """Adds the equations rows @ q[unknowns] = values to constraints made before.

    Args:
        constraints: Are added to.
        constraint_values: Their values, shape (num_unknowns,); those of the equations are filled in.
        unknowns: Unknowns that the equations speak of, shape (n,).
        rows: Shape (num_equations, n).
        values: Shape (num_equations,).
    Raises:
        Dependent: If an equation has no unknown left to be solved for.
    """
    if not len(rows):
        return
    so_far = constraints.resolve()
    follow = so_far.transform[unknowns]
    used = np.unique(follow.indices)
    length = np.linalg.norm(rows, axis=1)
    reduced = (rows @ follow[:, used].toarray()) / length[:, None]
    known = (values - rows @ (so_far.closure @ constraint_values)[unknowns]) / length
    _check_independent(reduced)
    # Columns with the largest pivots: the factors of what follows stay small.
    _, _, order = la.qr(reduced, mode="economic", pivoting=True)
    solved, others = order[: len(rows)], order[len(rows) :]
    inverse = la.inv(reduced[:, solved])
    factors = -inverse @ reduced[:, others]
    followers: Ints = so_far.free[used[solved]]
    leaders: Ints = so_far.free[used[others]]
    constraint_values[followers] = inverse @ known
    for unknown, weights in zip(followers, factors, strict=True):
        counts = np.abs(weights) > NEAR
        constraints.combine(int(unknown), leaders[counts], weights[counts])


def follow_best(columns: Floats) -> tuple[Sequence[int], Floats]:
    """Vectors of a space of motions, told by a few of their own entries.

    Args:
        columns: Vectors that span the space, shape (n, k); they may depend on each other.
    Returns:
        Numbers of r entries, r the space's dimension, and the matrix, shape (n, r), that gives all from these.
    """
    if not columns.size:
        return [], np.zeros((len(columns), 0))
    size = np.linalg.norm(columns, axis=0)
    scaled = columns / np.where(size > 0.0, size, 1.0)
    _, triangle, order = la.qr(scaled.T, mode="economic", pivoting=True)
    pivots = np.abs(np.diag(triangle))
    leading = order[: int(np.sum(pivots > NEAR * max(pivots[0], NEAR)))]
    return list(leading), scaled @ la.pinv(scaled[leading])


def _check_independent(rows: Floats) -> None:
    """Raises Dependent for the first row that is a combination of those before."""
    basis = np.zeros((0, rows.shape[1]))
    for number, row in enumerate(rows):
        left = row - basis.T @ (basis @ row)
        left -= basis.T @ (basis @ left)
        size = np.linalg.norm(left)
        if size < NEAR:
            raise Dependent(number)
        basis = np.vstack([basis, left / size])
