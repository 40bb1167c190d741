"""Terms of the global system: everything that adds forces and stiffness speaks this one language."""

from __future__ import annotations

from typing import Protocol

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


def block_pattern(rows: Ints, cols: Ints) -> tuple[Ints, Ints]:
    """Rows and columns of the entries of n dense blocks, row by row, shape (n k m,) each.

    Args:
        rows, cols: Of each block, shapes (n, k) and (n, m).
    """
    shape = (len(rows), rows.shape[1], cols.shape[1])
    row = np.broadcast_to(rows[:, :, None], shape)
    col = np.broadcast_to(cols[:, None, :], shape)
    return row.ravel(), col.ravel()


class Term(Protocol):
    """A part of the residual (gradient of the energy, N) in engine numbering, and its derivative.

    Each process returns its own share: the sum over processes is the whole.
    """

    def set_state(self, q: Floats) -> None:
        """Takes the current unknowns, shape (num_unknowns,), equal on all processes."""

    def energy(self, own: Floats) -> float:
        """This process's share of the potential whose gradient is the residual, mJ; NaN where the forces have none.

        Args:
            own: 1, or 0 for unknowns of images, whose energy does not count; shape (num_unknowns,).
        """
        ...

    def add_residual(self, residual: Floats) -> None:
        """Adds this process's share, shape (num_unknowns,)."""

    @property
    def pattern_version(self) -> int:
        """Number that changes whenever `tangent_pattern` does."""
        ...

    @property
    def spread(self) -> sp.csr_matrix | None:
        """Matrix that makes the numbers that `tangent_pattern` speaks of from the unknowns; None: they are the same."""
        ...

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """Rows and columns of this process's share of the tangent, shape (num_entries,) each."""
        ...

    def tangent_values(self) -> Floats:
        """Values of the tangent's entries, shape (num_entries,)."""
        ...


class Body(Protocol):
    """What a body shows to the system; see bodies.CurveBody."""

    block: int

    @property
    def num_unknowns(self) -> int: ...

    def set_state(self, q: Floats) -> None: ...

    def set_step(self, step: Floats) -> None: ...

    def energy(self) -> float: ...

    def residual(self) -> Floats: ...

    def tangent_pattern(self) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]: ...

    def tangent_values(self) -> Floats: ...


class BodyTerm:
    """Internal forces of a body whose unknowns begin at `first_unknown`."""

    pattern_version = 1
    spread = None

    def __init__(self, body: Body, first_unknown: int) -> None:
        self.body = body
        self.unknowns = slice(first_unknown, first_unknown + body.num_unknowns)

    def set_state(self, q: Floats) -> None:
        """See Term."""
        self.body.set_state(q[self.unknowns].reshape(-1, self.body.block))

    def set_step(self, step: Floats) -> None:
        """See GlobalSystem."""
        self.body.set_step(step[self.unknowns].reshape(-1, self.body.block))

    def energy(self, own: Floats) -> float:
        """See Term; images of a symmetric rope are equal parts of the body."""
        return self.body.energy() * float(own[self.unknowns].mean())

    def add_residual(self, residual: Floats) -> None:
        """See Term."""
        residual[self.unknowns] += self.body.residual()

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        rows, cols = (index.astype(np.int64) for index in self.body.tangent_pattern())
        return rows + self.unknowns.start, cols + self.unknowns.start

    def tangent_values(self) -> Floats:
        """See Term."""
        return self.body.tangent_values()


class LoadTerm:
    """Dead loads on unknowns (N on positions, N mm per mm on directors), shape (num_unknowns,)."""

    pattern_version = 1
    spread = None

    def __init__(self, num_unknowns: int, rank: int = 0) -> None:
        self.loads: Floats = np.zeros(num_unknowns)
        self._share = 1.0 if rank == 0 else 0.0
        self._none = np.empty(0, dtype=np.int64)
        self._q: Floats = np.zeros(num_unknowns)

    def set_state(self, q: Floats) -> None:
        """See Term; dead loads do not follow the state, their energy does."""
        self._q = q

    def energy(self, own: Floats) -> float:
        """See Term: minus the work of the loads on the way from zero unknowns."""
        return -self._share * float(self.loads @ (own * self._q))

    def add_residual(self, residual: Floats) -> None:
        """See Term; the loads are given to one process only."""
        residual -= self._share * self.loads

    def tangent_pattern(self) -> tuple[Ints, Ints]:
        """See Term."""
        return self._none, self._none

    def tangent_values(self) -> Floats:
        """See Term."""
        return np.empty(0)
