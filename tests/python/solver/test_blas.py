"""The reference BLAS is told from the tuned ones by what the process has mapped."""

from pathlib import Path

import pytest

from braidx.solver.blas import blas_libraries, blas_warning

REFERENCE = "/usr/lib/x86_64-linux-gnu/blas/libblas.so.3.12.1"
DEBIAN_OPENBLAS = "/usr/lib/x86_64-linux-gnu/openblas-pthread/libblas.so.3"
CONDA_OPENBLAS = "/opt/conda/lib/libopenblasp-r0.3.28.so"


def maps_file(folder: Path, *libraries: str) -> Path:
    path = folder / "maps"
    lines = [f"7f0000-7f1000 r-xp 00000000 08:01 42   {name}" for name in libraries]
    path.write_text("\n".join(["7f0000-7f1000 rw-p 00000000 00:00 0", *lines]))
    return path


@pytest.mark.parametrize("library", [DEBIAN_OPENBLAS, CONDA_OPENBLAS])
def test_a_tuned_blas_is_silent(tmp_path: Path, library: str) -> None:
    maps = maps_file(tmp_path, library, "/usr/lib/libm.so.6")
    assert blas_libraries(maps) == [Path(library)]
    assert blas_warning(maps) is None


def test_the_reference_blas_is_named_with_its_cure(tmp_path: Path) -> None:
    warning = blas_warning(maps_file(tmp_path, CONDA_OPENBLAS, REFERENCE))
    assert warning is not None
    assert REFERENCE in warning and "libopenblas0-pthread" in warning


def test_no_map_no_warning(tmp_path: Path) -> None:
    assert blas_warning(tmp_path / "missing") is None
