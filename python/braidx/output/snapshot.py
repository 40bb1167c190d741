"""What a picture or a file is made from: one state of the rope, as plain arrays."""

from __future__ import annotations

import os
from dataclasses import dataclass, fields, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ContactTable:
    """Contact elements of one state, one row each (m rows).

    Normals point from a to b; a negative gap is a penetration.
    """

    position: Array  # (m, 3), mm
    normal: Array  # (m, 3), unit vectors from a to b
    gap: Array  # (m,), mm
    normal_force: Array  # (m,), N, positive in compression
    friction_force: Array  # (m, 3), N, on b
    slip: Array  # (m,), mm, accumulated
    work: Array  # (m,), mJ, dissipated by friction
    yarn_a: NDArray[np.int64]  # (m,)
    yarn_b: NDArray[np.int64]  # (m,)

    def __post_init__(self) -> None:
        rows = len(self.gap)
        for field in fields(self):
            value = np.asarray(getattr(self, field.name))
            vector = field.name in ("position", "normal", "friction_force")
            expected = (rows, 3) if vector else (rows,)
            if value.shape != expected:
                raise ValueError(f"ContactTable.{field.name}: {value.shape}, expected {expected}.")


@dataclass(frozen=True)
class Snapshot:
    """One state of a rope whose axis is z.

    Raises:
        ValueError: If the arrays do not belong to the same yarns and nodes.
    """

    name: str
    centre_lines: tuple[Array, ...]  # per yarn (n_i, 3), mm
    radius: Array  # (num_yarns,), mm
    strand: NDArray[np.int64]  # (num_yarns,), strand of each yarn
    directors: tuple[Array, ...] | None = None  # per yarn (n_i, 2, 3), section vectors g1, g2
    tension: tuple[Array, ...] | None = None  # per yarn (n_i - 1,), N, per segment
    axial_stress: tuple[Array, ...] | None = None  # per yarn (n_i - 1,), MPa, per segment
    contacts: ContactTable | None = None

    def __post_init__(self) -> None:
        nodes = [len(line) for line in self.centre_lines]
        if len(self.radius) != len(nodes) or len(self.strand) != len(nodes):
            raise ValueError(
                f"Snapshot {self.name!r}: {len(nodes)} centre lines, {len(self.radius)} radii, "
                f"{len(self.strand)} strand numbers; give one of each per yarn."
            )
        shapes = {
            "centre_lines": [(n, 3) for n in nodes],
            "directors": [(n, 2, 3) for n in nodes],
            "tension": [(n - 1,) for n in nodes],
            "axial_stress": [(n - 1,) for n in nodes],
        }
        for key, expected in shapes.items():
            value = getattr(self, key)
            if value is not None and [np.shape(array) for array in value] != expected:
                raise ValueError(f"Snapshot {self.name!r}: {key} does not fit the yarns' nodes.")

    @property
    def num_yarns(self) -> int:
        return len(self.centre_lines)


def repeated(snapshot: Snapshot, times: int) -> Snapshot:
    """A sample laid end to end along the axis, so many times."""
    if times == 1:
        return snapshot
    periods = np.array([line[-1, 2] - line[0, 2] for line in snapshot.centre_lines])
    shifts = np.arange(times)[:, None] * [0.0, 0.0, periods.mean()]

    def nodal(values: Array, shifts: Array) -> Array:
        parts = [values[:-1] + shift for shift in shifts]
        return np.concatenate([*parts, values[-1:] + shifts[-1]])

    def each(values: tuple[Array, ...] | None) -> tuple[Array, ...] | None:
        return values and tuple(np.concatenate([value] * times) for value in values)

    return replace(
        snapshot,
        centre_lines=tuple(nodal(line, shifts) for line in snapshot.centre_lines),
        directors=snapshot.directors
        and tuple(nodal(pair, np.zeros(times)) for pair in snapshot.directors),
        tension=each(snapshot.tension),
        axial_stress=each(snapshot.axial_stress),
        contacts=snapshot.contacts and _repeated_contacts(snapshot.contacts, shifts),
    )


def _repeated_contacts(table: ContactTable, shifts: Array) -> ContactTable:
    columns = {
        field.name: np.concatenate([getattr(table, field.name)] * len(shifts))
        for field in fields(ContactTable)
    }
    columns["position"] = np.concatenate([table.position + shift for shift in shifts])
    return ContactTable(**columns)


_PER_YARN = ("centre_lines", "directors", "tension", "axial_stress")


def save(snapshot: Snapshot, path: Path) -> None:
    """Write a snapshot as compressed npz; the file appears whole or not at all."""
    counts = [len(line) for line in snapshot.centre_lines]
    arrays: dict[str, object] = {
        "name": snapshot.name,
        "counts": np.array(counts, dtype=np.int64),
        "radius": snapshot.radius,
        "strand": snapshot.strand,
    }
    for key in _PER_YARN:
        value = getattr(snapshot, key)
        if value is not None:
            arrays[key] = np.concatenate(value)
    if snapshot.contacts is not None:
        for field in fields(ContactTable):
            arrays[f"contacts_{field.name}"] = getattr(snapshot.contacts, field.name)
    part = path.with_name(path.name + ".part")
    with part.open("wb") as stream:
        np.savez_compressed(stream, **arrays)  # type: ignore[arg-type]
    os.replace(part, path)


def load(path: Path) -> Snapshot:
    """Read a snapshot written by `save`."""
    with np.load(path) as data:
        counts = data["counts"]
        per_yarn: dict[str, tuple[Array, ...]] = {}
        for key in _PER_YARN:
            if key in data:
                lengths = counts - 1 if key in ("tension", "axial_stress") else counts
                per_yarn[key] = tuple(np.split(data[key], np.cumsum(lengths)[:-1]))
        contacts = None
        if "contacts_gap" in data:
            contacts = ContactTable(
                **{f.name: data["contacts_" + f.name] for f in fields(ContactTable)}
            )
        return Snapshot(
            name=str(data["name"]),
            centre_lines=per_yarn["centre_lines"],
            radius=data["radius"],
            strand=data["strand"],
            directors=per_yarn.get("directors"),
            tension=per_yarn.get("tension"),
            axial_stress=per_yarn.get("axial_stress"),
            contacts=contacts,
        )
