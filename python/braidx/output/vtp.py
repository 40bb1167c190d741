"""VTK PolyData files (.vtp), binary and compressed, without VTK."""

from __future__ import annotations

import base64
import os
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from braidx.output.snapshot import Array

_TYPES = {"f4": "Float32", "i4": "Int32"}


def write(
    path: Path,
    points: Array,
    cells: Mapping[str, NDArray[np.int64]],
    point_data: Mapping[str, NDArray[Any]] | None = None,
    cell_data: Mapping[str, NDArray[Any]] | None = None,
) -> None:
    """Write points, cells and data; the file appears whole or not at all.

    Args:
        path: File name ending in .vtp.
        points: Shape (n, 3), mm.
        cells: Per kind ("Verts", "Lines", "Polys") the points of each cell, shape
            (num_cells, points per cell).
        point_data: Arrays of n rows by name.
        cell_data: Arrays by name, one row per cell in the order Verts, Lines, Polys.
    """
    counts = {kind: len(cells.get(kind, ())) for kind in ("Verts", "Lines", "Polys")}
    numbers = "".join(f' NumberOf{kind}="{count}"' for kind, count in counts.items())
    parts = [
        '<?xml version="1.0"?>',
        '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"'
        ' header_type="UInt64" compressor="vtkZLibDataCompressor">',
        "<PolyData>",
        f'<Piece NumberOfPoints="{len(points)}"{numbers}>',
        "<Points>",
        _array("Points", points),
        "</Points>",
    ]
    for kind, connectivity in cells.items():
        size, count = connectivity.shape[1], len(connectivity)
        parts += [
            f"<{kind}>",
            _array("connectivity", connectivity.ravel()),
            _array("offsets", size * np.arange(1, count + 1)),
            f"</{kind}>",
        ]
    for tag, data in (("PointData", point_data), ("CellData", cell_data)):
        parts += [
            f"<{tag}>",
            *(_array(n, np.asarray(v)) for n, v in (data or {}).items()),
            f"</{tag}>",
        ]
    parts += ["</Piece>", "</PolyData>", "</VTKFile>", ""]
    part = path.with_name(path.name + ".part")
    part.write_text("\n".join(parts), "ascii")
    os.replace(part, path)


def _array(name: str, values: NDArray[np.generic]) -> str:
    kind = "f4" if values.dtype.kind == "f" else "i4"
    raw = np.ascontiguousarray(values, dtype="<" + kind).tobytes()
    packed = zlib.compress(raw, 6)
    # One block: number of blocks, its size, size of a shorter last block (none), packed size.
    header = np.array([1, len(raw), 0, len(packed)] if raw else [0, 0, 0], dtype="<u8").tobytes()
    text = base64.b64encode(header) + (base64.b64encode(packed) if raw else b"")
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    return (
        f'<DataArray type="{_TYPES[kind]}" Name="{name}"{components} format="binary">'
        f"{text.decode()}</DataArray>"
    )
