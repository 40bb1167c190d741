"""Which BLAS the linear algebra of this process uses, and a warning when it is the slow one."""

from __future__ import annotations

from pathlib import Path

FAST = ("openblas", "mkl", "blis", "atlas", "armpl", "accelerate", "flexiblas")


def blas_libraries(maps: Path = Path("/proc/self/maps")) -> list[Path]:
    """BLAS libraries mapped into this process, symbolic links resolved by the system.

    Args:
        maps: The process's memory map, one mapping per line, the path in the sixth column.
    Returns:
        Their paths, sorted; empty where the system offers no such map.
    """
    if not maps.is_file():
        return []
    columns = (line.split(maxsplit=5) for line in maps.read_text().splitlines())
    files = {Path(column[5]) for column in columns if len(column) == 6}
    return sorted(f for f in files if f.name.startswith("libblas.") or _is_fast(f))


def blas_warning(maps: Path = Path("/proc/self/maps")) -> str | None:
    """A sentence for the user when NumPy or PETSc run on the reference BLAS, else None.

    Call it after numpy and petsc4py are imported. With the reference BLAS the sparse factorisations
    are several times slower: MUMPS 8 times for 31,000 unknowns.
    """
    slow = [path for path in blas_libraries(maps) if not _is_fast(path)]
    if not slow:
        return None
    return (
        f"the linear algebra uses the reference BLAS ({slow[0]}), up to 8 times slower than "
        "OpenBLAS; install that: apt install libopenblas0-pthread, or conda install 'libblas=*=*openblas'"
    )


def _is_fast(path: Path) -> bool:
    """True for a tuned BLAS; Debian keeps OpenBLAS's libblas.so.3 in a folder named after it."""
    parts = (path.parent.name.lower(), path.name.lower())
    return path.suffix != "" and any(name in part for name in FAST for part in parts)
