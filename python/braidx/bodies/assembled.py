"""What curves and solids have in common: a state, and forms that are assembled in it."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np
import numpy.typing as npt
from dolfinx import fem

from .assembly import Assembler
from .layout import FloatArray, IntArray


class AssembledBody(ABC):
    """A body in canonical numbering: node by node, `block` components.

    A subclass sets the attributes that are declared here.
    """

    block: int
    _state: fem.Function
    _step: fem.Function | None = None  # if the tangent depends on it
    _nodes: IntArray  # canonical node of each local block of degrees of freedom
    _assembler: Assembler

    @property
    @abstractmethod
    def num_nodes(self) -> int:
        """Nodes of all processes."""

    @property
    def num_unknowns(self) -> int:
        return self.num_nodes * self.block

    def set_state(self, q: FloatArray) -> None:
        """Take over the current unknowns, the same on each rank, shape (num_nodes, block)."""
        self._state.x.array[:] = q[self._nodes].ravel()

    def set_step(self, step: FloatArray) -> None:
        """The step of Newton's method that led to the current state, shape (num_nodes, block); zero if none did.

        Where strains are quadratic in the unknowns, stresses after a step differ from those that its linear prediction
        foresaw by the square of the step. In thin rods these are axial stresses that the next step takes away again;
        in the tangent they are no more than noise, by which iterations stray. The tangent therefore takes the stresses
        that were foreseen (mixed integration points: Magisano, Leonetti, Garcea 2017); the residual does not.
        """
        if self._step is not None:
            self._step.x.array[:] = step[self._nodes].ravel()

    def energy(self) -> float:
        """Stored energy of the elements of this rank, mJ."""
        return self._assembler.energy()

    def residual(self) -> FloatArray:
        """This rank's part of the internal forces, shape (num_unknowns,), N (N mm on directors).

        The storage is reused by the next call.
        """
        return self._assembler.residual()

    def tangent_pattern(self) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
        """Rows and columns of this rank's part of the tangent, fixed for the body's lifetime."""
        return self._assembler.tangent_pattern()

    def tangent_values(self) -> FloatArray:
        """This rank's part of the tangent, one value per entry of `tangent_pattern`.

        The storage is reused by the next call.
        """
        return self._assembler.tangent_values()
