"""The environment braidx runs in: the launcher's shell parts, and what Python checks about it."""

from braidx.cli.environment.blas import blas_libraries, blas_warning

__all__ = ["blas_libraries", "blas_warning"]
