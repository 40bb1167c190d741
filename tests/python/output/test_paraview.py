"""ParaView files: read back with VTK where it is installed, and as XML."""

from __future__ import annotations

import base64
import xml.etree.ElementTree as xml
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from bent_example import bent_rope
from rope_example import rope

from braidx.output import vtp
from braidx.output.paraview import (
    Series,
    sections,
    write_contacts,
    write_core,
    write_skins,
    write_tubes,
)


def test_tubes_and_contacts_are_what_vtk_reads(tmp_path: Path) -> None:
    reader = pytest.importorskip("vtkmodules.vtkIOXML")
    support = pytest.importorskip("vtkmodules.util.numpy_support")
    snapshot = rope(nodes=9, stressed=True)
    write_tubes(snapshot, tmp_path / "t.vtp")
    write_contacts(snapshot, tmp_path / "c.vtp")

    def load(name: str) -> object:
        source = reader.vtkXMLPolyDataReader()
        source.SetFileName(str(tmp_path / name))
        source.Update()
        return source.GetOutput()

    tubes, contacts = load("t.vtp"), load("c.vtp")
    assert tubes.GetNumberOfPolys() == 84 * 8 * 10
    points = support.vtk_to_numpy(tubes.GetPoints().GetData()).reshape(84, 9, 10, 3)
    distance = np.linalg.norm(points - np.array(snapshot.centre_lines)[:, :, None], axis=3)
    np.testing.assert_allclose(distance, 0.86, rtol=1e-4)
    assert snapshot.axial_stress is not None and snapshot.contacts is not None
    stress = support.vtk_to_numpy(tubes.GetCellData().GetArray("axial stress (MPa)"))
    np.testing.assert_allclose(stress[::10], np.concatenate(snapshot.axial_stress), rtol=1e-6)
    force = support.vtk_to_numpy(contacts.GetPointData().GetArray("friction force (N)"))
    np.testing.assert_allclose(force, snapshot.contacts.friction_force, rtol=1e-5, atol=1e-12)


def test_empty_arrays(tmp_path: Path) -> None:
    empty = np.zeros((0, 1), dtype=np.int64)
    vtp.write(tmp_path / "e.vtp", np.zeros((0, 3)), {"Verts": empty}, {"gap (mm)": np.zeros(0)})
    piece = xml.parse(tmp_path / "e.vtp").getroot()[0][0]
    assert piece.get("NumberOfPoints") == "0"


def test_series_can_be_resumed(tmp_path: Path) -> None:
    snapshot = rope(nodes=5)
    snapshot = replace(snapshot, directors=tuple(sections(snapshot)))
    series = Series(tmp_path)
    for increment in (1, 2, 3):
        series.append(snapshot, increment)
    series = Series(tmp_path, after=2)
    series.append(replace(snapshot, contacts=None), 5)

    def entries(kind: str) -> list[str]:
        collection = xml.parse(tmp_path / f"{kind}.pvd").getroot()[0]
        return [entry.get("timestep", "") for entry in collection]

    assert entries("tubes") == ["1", "2", "5"] and entries("sections") == ["1", "2", "5"]
    assert entries("contacts") == ["1", "2", "3"]  # as it was: nothing was added
    for name in ("tubes_00005.vtp", "sections_00005.vtp", "contacts_00002.vtp"):
        assert (tmp_path / name).exists()


def test_what_is_missing_is_named(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="contacts"):
        write_contacts(replace(rope(nodes=5), contacts=None), tmp_path / "c.vtp")


def array(path: Path, name: str) -> np.ndarray:
    """An array of a file, by what vtp writes: a header of four numbers, then packed numbers."""
    for entry in xml.parse(path).getroot().iter("DataArray"):
        if entry.get("Name") == name:
            text = str(entry.text)
            kind = {"Float32": "<f4", "Int32": "<i4"}[str(entry.get("type"))]
            return np.frombuffer(zlib.decompress(base64.b64decode(text[44:])), dtype=kind)
    raise AssertionError(f"{path.name} has no {name}")


def test_skins_and_core_are_written(tmp_path: Path) -> None:
    one = bent_rope(pitches=0.5, nodes=13, solids=True)
    Series(tmp_path).append(one, 4)
    stress = array(tmp_path / "skins_00004.vtp", "von Mises (MPa)")
    owner = array(tmp_path / "skins_00004.vtp", "yarn (-)")
    assert len(stress) == 13 * 12 * 12 * 2
    np.testing.assert_allclose(stress[:144], one.skins[0].von_mises, rtol=1e-6)
    np.testing.assert_array_equal(np.unique(owner), np.arange(-1, 12))
    points = array(tmp_path / "core_00004.vtp", "Points").reshape(2, 13, 24, 3)
    distance = np.linalg.norm(points - one.core.line[:, None], axis=-1)
    np.testing.assert_allclose(distance[0], 2.0, rtol=1e-5)
    np.testing.assert_allclose(distance[1], 0.8, rtol=1e-5)
    kinds = array(tmp_path / "contacts_00004.vtp", "kind (-)")
    np.testing.assert_array_equal(kinds, one.contacts.kind)
    for kind in ("skins", "core"):
        assert 'timestep="4"' in (tmp_path / f"{kind}.pvd").read_text()
    bare = replace(one, skins=(), core=None)
    for write, what in ((write_skins, "skins"), (write_core, "core")):
        with pytest.raises(ValueError, match=what):
            write(bare, tmp_path / "x.vtp")
