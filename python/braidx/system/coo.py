"""PETSc's COO interface, which petsc4py lacks in some releases, reached in the library it is linked to."""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np
import numpy.typing as npt
from petsc4py import PETSc


@cache
def _library() -> ctypes.CDLL:
    # Symbols are looked up in the extension's own dependencies: the very PETSc that it uses.
    return ctypes.PyDLL(PETSc.__file__)


def _pointer(array: np.ndarray) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def _call(name: str, *arguments: object) -> None:
    function = getattr(_library(), name)
    function.restype = ctypes.c_int
    code = function(*arguments)
    if code:
        raise PETSc.Error(code)


def preallocate(matrix: PETSc.Mat, rows: npt.NDArray, cols: npt.NDArray) -> None:
    """Lays a matrix out for values at (rows, cols), global indices; negative ones are dropped."""
    i, j = (
        np.array(index, dtype=PETSc.IntType) for index in (rows, cols)
    )  # PETSc may reorder them
    _call(
        "MatSetPreallocationCOO",
        ctypes.c_void_p(matrix.handle),
        ctypes.c_ssize_t(len(i)),
        _pointer(i),
        _pointer(j),
    )


def set_values(matrix: PETSc.Mat, values: npt.NDArray[np.float64]) -> None:
    """Replaces the matrix by the sums of the values, in the order given to `preallocate`."""
    v = np.ascontiguousarray(values, dtype=PETSc.ScalarType)
    insert = ctypes.c_int(int(PETSc.InsertMode.INSERT_VALUES))
    _call("MatSetValuesCOO", ctypes.c_void_p(matrix.handle), _pointer(v), insert)
