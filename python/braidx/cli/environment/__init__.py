"""The environment braidx runs in: the launcher's shell parts, and what Python checks about it."""

from braidx.cli.environment.blas import blas_libraries, blas_warning
from braidx.cli.environment.console import make_console, rank

__all__ = ["blas_libraries", "blas_warning", "make_console", "rank"]
