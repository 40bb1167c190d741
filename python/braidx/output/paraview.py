"""Files for ParaView: yarns, core, surfaces of solids, contact elements, as time series.

Every name of an array states its unit. `tubes.pvd`, `sections.pvd`, `contacts.pvd`, `skins.pvd` and
`core.pvd` are opened in ParaView; their time is the increment.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from braidx.output import vtp
from braidx.output.arrays import Integers
from braidx.output.cuts import frames, node_tangents
from braidx.output.measures import layers
from braidx.output.snapshot import Array, Snapshot

_KINDS = ("tubes", "sections", "contacts", "skins", "core")
_SIDES = 10  # of a tube
_CORE_SIDES = 24
_ENTRY = re.compile(r'timestep="(\d+)" file="([^"]+)"')


class Series:
    """The ParaView files of a run.

    Args:
        folder: Where they go; made if it is missing.
        after: Keep the entries up to and including this increment (a resume); None starts anew.
    """

    def __init__(self, folder: Path, after: int | None = None) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        self._entries: dict[str, dict[int, str]] = {kind: {} for kind in _KINDS}
        if after is not None:
            for kind, entries in self._entries.items():
                index = folder / f"{kind}.pvd"
                text = index.read_text("utf-8") if index.exists() else ""
                entries.update({int(t): f for t, f in _ENTRY.findall(text) if int(t) <= after})

    def append(self, snapshot: Snapshot, increment: int) -> None:
        """Write one state; of all but the tubes only what the snapshot has."""
        writers = {"tubes": write_tubes}
        if snapshot.directors is not None:
            writers["sections"] = write_sections
        if snapshot.contacts is not None:
            writers["contacts"] = write_contacts
        if snapshot.skins:
            writers["skins"] = write_skins
        if snapshot.core is not None:
            writers["core"] = write_core
        for kind, write in writers.items():
            name = f"{kind}_{increment:05d}.vtp"
            write(snapshot, self._folder / name)
            self._entries[kind][increment] = name
            self._write_index(kind)

    def _write_index(self, kind: str) -> None:
        entries = sorted(self._entries[kind].items())
        lines = [f'<DataSet timestep="{t}" file="{name}"/>' for t, name in entries]
        text = '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n'
        text += "\n".join(lines) + "\n</Collection>\n</VTKFile>\n"
        part = self._folder / f"{kind}.pvd.part"
        part.write_text(text, "utf-8")
        os.replace(part, self._folder / f"{kind}.pvd")


def sections(snapshot: Snapshot) -> Iterator[Array]:
    """Section vectors g1, g2 of each yarn, shape (n_i, 2, 3); unit and across it for cables."""
    if snapshot.directors is not None:
        yield from snapshot.directors
    else:
        for line in snapshot.centre_lines:
            yield frames(node_tangents(line))


def write_tubes(snapshot: Snapshot, path: Path) -> None:
    """Surfaces of the yarns, with strand, layer, yarn, tension and axial stress per face."""
    points, faces, owner = [], [], []
    offset = 0
    for yarn, (line, section) in enumerate(zip(snapshot.centre_lines, sections(snapshot))):
        ring, quads = _tube(line, section, float(snapshot.radius[yarn]), _SIDES)
        points.append(ring)
        faces.append(quads + offset)
        owner.append(np.full(len(faces[-1]), yarn))
        offset += len(points[-1])
    yarn_of = np.concatenate(owner)
    data = {
        "yarn (-)": yarn_of,
        "strand (-)": snapshot.strand[yarn_of],
        "layer (-)": layers(snapshot)[yarn_of],
    }
    if snapshot.tension is not None:
        data["tension (N)"] = np.concatenate(snapshot.tension).repeat(_SIDES)
    if snapshot.axial_stress is not None:
        data["axial stress (MPa)"] = np.concatenate(snapshot.axial_stress).repeat(_SIDES)
    vtp.write(path, np.concatenate(points), {"Polys": np.concatenate(faces)}, cell_data=data)


def write_core(snapshot: Snapshot, path: Path) -> None:
    """Surface of the core about its line, and of its bore; "inner (-)" is 1 on the bore.

    Raises:
        ValueError: If the snapshot has no core.
    """
    core = snapshot.core
    if core is None:
        raise ValueError(f"Snapshot {snapshot.name!r} has no core to write.")
    radii = [core.radius] + [core.inner_radius] * (core.inner_radius > 0.0)
    section = frames(node_tangents(core.line))
    parts = [_tube(core.line, section, radius, _CORE_SIDES) for radius in radii]
    faces = [quads + number * len(parts[0][0]) for number, (_, quads) in enumerate(parts)]
    data = {"inner (-)": np.repeat(np.arange(len(parts)), len(faces[0]))}
    points = np.concatenate([ring for ring, _ in parts])
    vtp.write(path, points, {"Polys": np.concatenate(faces)}, cell_data=data)


def write_skins(snapshot: Snapshot, path: Path) -> None:
    """Surfaces of solids with von Mises stress and owner (the yarn, -1 the core) per face.

    Quadrilaterals are written as two triangles.

    Raises:
        ValueError: If the snapshot has no skins.
    """
    if not snapshot.skins:
        raise ValueError(f"Snapshot {snapshot.name!r} has no skins to write.")
    faces, stress, owner = [], [], []
    offset = 0
    for skin in snapshot.skins:
        corners, face = skin.triangles()
        faces.append(corners + offset)
        stress.append(skin.von_mises[face])
        owner.append(skin.owner[face])
        offset += len(skin.points)
    data = {"yarn (-)": np.concatenate(owner), "von Mises (MPa)": np.concatenate(stress)}
    points = np.concatenate([skin.points for skin in snapshot.skins])
    vtp.write(path, points, {"Polys": np.concatenate(faces)}, cell_data=data)


def _tube(line: Array, section: Array, radius: float, sides: int) -> tuple[Array, Integers]:
    """Points of a tube, ring by ring, and its quadrilaterals."""
    angle = np.linspace(0.0, 2 * np.pi, sides, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)])
    ring = line[:, None] + radius * np.einsum("nkc,ks->nsc", section, circle)
    first = sides * np.arange(len(line) - 1)[:, None] + np.arange(sides)
    second = sides * np.arange(len(line) - 1)[:, None] + (np.arange(sides) + 1) % sides
    quads = np.stack([first, second, second + sides, first + sides], axis=-1)
    return ring.reshape(-1, 3), quads.reshape(-1, 4)


def write_sections(snapshot: Snapshot, path: Path) -> None:
    """Nodes with their section vectors g1 and g2 (show them with the Glyph filter).

    Raises:
        ValueError: If the snapshot has no directors.
    """
    if snapshot.directors is None:
        raise ValueError(f"Snapshot {snapshot.name!r} has no directors; only beams have them.")
    points = np.concatenate(snapshot.centre_lines)
    vectors = np.concatenate(snapshot.directors)
    counts = [len(line) for line in snapshot.centre_lines]
    data = {
        "g1 (-)": vectors[:, 0],
        "g2 (-)": vectors[:, 1],
        "yarn (-)": np.repeat(np.arange(snapshot.num_yarns), counts),
    }
    vtp.write(path, points, {"Verts": np.arange(len(points))[:, None]}, point_data=data)


def write_contacts(snapshot: Snapshot, path: Path) -> None:
    """Contact elements as points with gap, forces, reversible slip and friction work.

    Raises:
        ValueError: If the snapshot has no contacts.
    """
    table = snapshot.contacts
    if table is None:
        raise ValueError(f"Snapshot {snapshot.name!r} has no contacts to write.")
    data: dict[str, NDArray[Any]] = {
        "normal (-)": table.normal,
        "gap (mm)": table.gap,
        "normal force (N)": table.normal_force,
        "friction force (N)": table.friction_force,
        "reversible slip (mm)": table.reversible_slip,
        "friction work (mJ)": table.work,
        "yarn a (-)": table.yarn_a,
        "yarn b (-)": table.yarn_b,
        "kind (-)": table.kind,
        "length (mm) or area (mm2)": table.measure,
        "per area (-)": table.per_area.astype(np.int64),
    }
    vtp.write(path, table.position, {"Verts": np.arange(len(table.gap))[:, None]}, point_data=data)
