"""Linear constraints between unknowns: q = T p + c, T sparse, p the free unknowns."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class ConstraintMap:
    """Resolved constraints.

    Attributes:
        transform: T, shape (num_unknowns, num_free).
        closure: Maps the inhomogeneous values of the constraints to c, shape (num_unknowns, num_unknowns).
        free: Engine numbers of the free unknowns, shape (num_free,).
        test: Displacements that equilibrium is asked for, shape as T: T itself, or T without the rows of images,
            whose equilibrium is that of what they are images of.
        copies: How often the equilibrium of an unknown occurs, shape (num_unknowns,): once, or as often as images
            repeat it and once more; images themselves count 0.
    """

    transform: sp.csr_matrix
    closure: sp.csr_matrix
    free: Ints
    test: sp.csr_matrix
    copies: Floats

    @cached_property
    def held(self) -> npt.NDArray[np.bool_]:
        """Whether each unknown cannot move, shape (num_unknowns,)."""
        return np.asarray(np.diff(self.transform.indptr) == 0)

    @cached_property
    def moving_copies(self) -> Floats:
        """`copies` of unknowns that can move, 0 of those that are held, shape (num_unknowns,)."""
        return np.where(self.held, 0.0, self.copies)

    def expand(self, free_values: Floats, constraint_values: Floats) -> Floats:
        """All unknowns q from the free ones p, shape (num_unknowns,)."""
        return self.transform @ free_values + self.closure @ constraint_values

    def reduce(self, residual: Floats) -> Floats:
        """What virtual work leaves of a residual for the free unknowns, T^T r, shape (num_free,)."""
        return self.test.T @ residual

    def reduce_pattern(
        self, rows: Ints, cols: Ints, spread: sp.csr_matrix | None = None
    ) -> ReducedPattern:
        """COO entries of T^T A T from those of A; of T^T S^T A S T if A speaks of S times the unknowns."""
        if spread is None:
            return ReducedPattern.of(self.test, self.transform, rows, cols)
        test, transform = (sp.csr_matrix(spread @ m) for m in (self.test, self.transform))
        for matrix in (test, transform):
            # What cancels, such as the two ends of a yarn that are held alike.
            matrix.eliminate_zeros()
        return ReducedPattern.of(test, transform, rows, cols)


@dataclass(frozen=True)
class ReducedPattern:
    """COO entries of T^T A T; entry k takes factor[k] times value source[k] of A.

    `source` and `factor` are None where every unknown follows at most one free one with factor one: then
    the reduction is a mere renumbering, and entries of held unknowns have negative indices.
    """

    rows: Ints
    cols: Ints
    source: Ints | None
    factor: Floats | None

    @staticmethod
    def of(test: sp.csr_matrix, transform: sp.csr_matrix, rows: Ints, cols: Ints) -> ReducedPattern:
        """See ConstraintMap.reduce_pattern."""
        counts = np.diff(transform.indptr)
        if test is transform and counts.max(initial=0) <= 1 and np.all(transform.data == 1.0):
            number = np.full(len(counts), -1, dtype=np.int64)
            number[counts == 1] = transform.indices
            return ReducedPattern(number[rows], number[cols], None, None)
        num_cols = counts[cols]
        num = np.diff(test.indptr)[rows] * num_cols
        source = np.repeat(np.arange(len(rows)), num)
        within = np.arange(len(source)) - np.repeat(np.cumsum(num) - num, num)
        at_row = test.indptr[rows][source] + within // num_cols[source]
        at_col = transform.indptr[cols][source] + within % num_cols[source]
        return ReducedPattern(
            test.indices[at_row].astype(np.int64),
            transform.indices[at_col].astype(np.int64),
            source,
            test.data[at_row] * transform.data[at_col],
        )

    def values(self, values: Floats) -> Floats:
        """Values of the entries from those of A."""
        if self.source is None or self.factor is None:
            return values
        return values[self.source] * self.factor


class Constraints:
    """Collects linear constraints; each unknown may follow others only once."""

    def __init__(self, num_unknowns: int) -> None:
        self.num_unknowns = num_unknowns
        self._followers = np.zeros(num_unknowns, dtype=bool)
        self._rows: list[Ints] = []
        self._cols: list[Ints] = []
        self._factors: list[Floats] = []
        self._copies = np.ones(num_unknowns)

    def hold(self, unknowns: npt.ArrayLike) -> None:
        """Unknowns that take their value from the constraint values alone."""
        self._follow(np.asarray(unknowns, dtype=np.int64))

    def tie(self, unknowns: npt.ArrayLike, to: npt.ArrayLike) -> None:
        """unknowns = to + constraint value."""
        followers, leaders = np.broadcast_arrays(
            np.asarray(unknowns, np.int64), np.asarray(to, np.int64)
        )
        self._follow(followers)
        self._add(followers, leaders, np.ones(len(followers)))

    def combine(self, unknown: int, of: npt.ArrayLike, factors: npt.ArrayLike) -> None:
        """unknown = sum of factors * of + constraint value."""
        self.combine_each(
            [unknown], np.atleast_2d(np.asarray(of)), np.atleast_2d(np.asarray(factors))
        )

    def combine_each(
        self, unknowns: npt.ArrayLike, of: npt.ArrayLike, factors: npt.ArrayLike
    ) -> None:
        """Row by row unknowns[i] = sum of factors[i] * of[i] + constraint value; shapes (n,), (n, k), (n, k)."""
        leaders = np.asarray(of, dtype=np.int64)
        followers = np.asarray(unknowns, dtype=np.int64)
        self._follow(followers)
        spread = np.broadcast_to(followers[:, None], leaders.shape)
        weights = np.broadcast_to(np.asarray(factors, dtype=float), leaders.shape)
        self._add(spread.ravel(), leaders.ravel(), weights.ravel())

    def repeat(self, unknowns: npt.ArrayLike, of: npt.ArrayLike) -> None:
        """Unknowns whose equilibrium repeats that of others, which they follow, by symmetry."""
        self._copies[np.asarray(unknowns, dtype=np.int64)] = 0.0
        np.add.at(self._copies, np.asarray(of, dtype=np.int64), 1.0)

    def hold_mean(self, unknowns: npt.ArrayLike) -> None:
        """The mean of unknowns is the constraint value of the last one over their number."""
        group = np.asarray(unknowns, dtype=np.int64)
        self.combine(int(group[-1]), group[:-1], -np.ones(len(group) - 1))

    def resolve(self) -> ConstraintMap:
        """Substitutes chains of constraints.

        Raises:
            ValueError: If constraints follow each other in a circle.
        """
        n = self.num_unknowns
        rows, cols = np.concatenate([*self._rows, []]), np.concatenate([*self._cols, []])
        follow = sp.csr_matrix((np.concatenate([*self._factors, []]), (rows, cols)), shape=(n, n))
        closure = power = sp.identity(n, format="csr")
        for _ in range(20):
            power = follow @ power
            if power.nnz == 0:
                free = np.flatnonzero(~self._followers)
                transform = test = sp.csr_matrix(closure[:, free])
                if not self._copies.all():
                    test = sp.csr_matrix(sp.diags((self._copies > 0).astype(float)) @ transform)
                    test.eliminate_zeros()
                return ConstraintMap(transform, sp.csr_matrix(closure), free, test, self._copies)
            closure = closure + power
        raise ValueError(
            "constraints of unknowns follow each other in a circle; release one of them"
        )

    def _follow(self, unknowns: Ints) -> None:
        if self._followers[unknowns].any():
            twice = unknowns[self._followers[unknowns]][0]
            raise ValueError(f"unknown {twice} is constrained twice; drop one of its constraints")
        self._followers[unknowns] = True

    def _add(self, rows: Ints, cols: Ints, factors: Floats) -> None:
        self._rows.append(rows)
        self._cols.append(cols)
        self._factors.append(factors)
