"""The global system: terms in engine numbering, reduced by the constraint map, as one PETSc COO matrix."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from mpi4py import MPI
from petsc4py import PETSc

from . import coo
from .constraints import ConstraintMap, Floats
from .terms import BodyTerm, Term


class GlobalSystem:
    """Residual and tangent of all terms for the free unknowns.

    Attributes:
        constraints: The current constraint map.
        constraint_values: Inhomogeneous values of the constraints, shape (num_unknowns,), mm.
        term_norms: Norm of each term in the last residual, N, shape (num_terms,). What bodies ask of supports counts,
            for it tells how they are strained; what others do to unknowns that are held does not: nothing moves there.
        force_scale: Norm of the largest term of the last residual, N: what "small" is measured against.
    """

    def __init__(
        self,
        comm: MPI.Comm,
        terms: Sequence[Term],
        constraints: ConstraintMap,
        constraint_values: Floats,
    ) -> None:
        self.comm = comm
        self.terms = list(terms)
        self.constraints = constraints
        self.constraint_values = constraint_values
        self.term_norms: Floats = np.zeros(len(terms))
        self.force_scale = 0.0
        self.q: Floats = np.zeros(len(constraint_values))
        self._make_vector()
        self.matrix: PETSc.Mat | None = None
        self._versions: tuple[int, ...] = ()
        self._laid_out: ConstraintMap | None = None

    def _make_vector(self) -> None:
        """A distributed vector of the free unknowns."""
        self.vector = PETSc.Vec().createMPI((PETSc.DECIDE, self.num_free), comm=self.comm)
        self.vector.setUp()
        self._counts = np.array(self.comm.allgather(self.vector.getLocalSize()))

    @property
    def num_free(self) -> int:
        """Number of free unknowns of all processes."""
        return len(self.constraints.free)

    def update_pattern(self) -> bool:
        """Lays out the matrix anew, if the contact elements or the constraints have outgrown it.

        Returns:
            Whether there is a new matrix.
        """
        versions = tuple(term.pattern_version for term in self.terms)
        same = versions == self._versions and self.constraints is self._laid_out
        if self.comm.allreduce(same, op=MPI.LAND):
            return False
        self._versions, self._laid_out = versions, self.constraints
        if self.vector.getSize() != self.num_free:
            self._make_vector()
        pieces = [
            self.constraints.reduce_pattern(*term.tangent_pattern(), term.spread)
            for term in self.terms
        ]
        self._pieces = pieces
        if self.matrix is not None:
            self.matrix.destroy()
        size = (self.vector.getLocalSize(), self.num_free)
        matrix = PETSc.Mat().create(comm=self.comm)
        matrix.setSizes((size, size))
        matrix.setType(PETSc.Mat.Type.AIJ)
        coo.preallocate(
            matrix,
            np.concatenate([p.rows for p in pieces]),
            np.concatenate([p.cols for p in pieces]),
        )
        self.matrix = matrix
        return True

    def set_state(self, q: Floats) -> None:
        """Hands all unknowns, shape (num_unknowns,), to the terms."""
        self.q = q
        for term in self.terms:
            term.set_state(q)

    def set_step(self, step: Floats) -> None:
        """Hands the step that led to the current state, shape (num_unknowns,), to the bodies.

        See AssembledBody.set_step.
        """
        for term in self.terms:
            if isinstance(term, BodyTerm):
                term.set_step(step)

    def energy(self) -> float:
        """Potential of all terms at the current state, mJ; NaN where a term has none (see Term)."""
        own = np.where(self.constraints.copies > 0, 1.0, 0.0)
        share = sum(term.energy(own) for term in self.terms)
        return float(self.comm.allreduce(share))

    def residual(self) -> Floats:
        """Residual of all unknowns at the current state, shape (num_unknowns,), N; zero in equilibrium where free.

        At held unknowns it is the force that holds them (the reaction). Images lack parts of it: terms may leave out
        what acts among them, and norms count what they repeat (ConstraintMap.copies) instead.
        """
        parts = np.zeros((len(self.terms), len(self.q)))
        for part, term in zip(parts, self.terms, strict=True):
            term.add_residual(part)
        if self.comm.size > 1:
            self.comm.Allreduce(MPI.IN_PLACE, parts)
        everywhere, moving = self.constraints.copies, self.constraints.moving_copies
        counted = [everywhere if isinstance(term, BodyTerm) else moving for term in self.terms]
        self.term_norms = np.sqrt([part**2 @ counts for part, counts in zip(parts, counted)])
        self.force_scale = float(self.term_norms.max())
        return parts.sum(axis=0)

    def tangent_times(self, direction: Floats) -> Floats:
        """Derivative of `residual` at the current state along a direction, shapes (num_unknowns,)."""
        change = np.zeros(len(self.q))
        for term in self.terms:
            rows, cols = term.tangent_pattern()
            along = direction if term.spread is None else term.spread @ direction
            forces = np.bincount(rows, term.tangent_values() * along[cols], len(along))
            change += forces if term.spread is None else term.spread.T @ forces
        if self.comm.size > 1:
            self.comm.Allreduce(MPI.IN_PLACE, change)
        return change

    def free_values(self, q: Floats) -> Floats:
        """The free unknowns of q, shape (num_free,)."""
        return q[self.constraints.free]

    def expand(self, free_values: Floats) -> Floats:
        """All unknowns of given free ones, shape (num_unknowns,)."""
        return self.constraints.expand(free_values, self.constraint_values)

    def gather(self, vector: PETSc.Vec) -> Floats:
        """A distributed vector of free unknowns as one array, equal on all processes."""
        if self.comm.size == 1:
            return vector.array_r.copy()
        whole = np.empty(self.num_free)
        self.comm.Allgatherv(vector.array_r, (whole, self._counts))
        return whole

    def scatter(self, values: Floats, vector: PETSc.Vec) -> None:
        """This process's part of an array of free unknowns into a distributed vector."""
        first, last = vector.getOwnershipRange()
        vector.array[:] = values[first:last]

    def assemble_residual(self, vector: PETSc.Vec) -> None:
        """Residual of the free unknowns at the current state."""
        self.scatter(self.constraints.reduce(self.residual()), vector)

    def assemble_tangent(self) -> None:
        """Derivative of the residual of the free unknowns at the current state, into `matrix`."""
        values = [
            piece.values(term.tangent_values())
            for piece, term in zip(self._pieces, self.terms, strict=True)
        ]
        assert self.matrix is not None
        coo.set_values(self.matrix, np.concatenate(values))
