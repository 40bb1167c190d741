"""What a picture or a file is made from: one state of the rope, as plain arrays."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from braidx.output.arrays import Array, Integers
from braidx.output.columns import columns, read_columns
from braidx.output.contact_table import ContactTable, repeated_contacts
from braidx.output.core_line import CoreLine
from braidx.output.sheave_picture import SheavePicture
from braidx.output.skin_picture import SkinPicture

__all__ = ["Array", "ContactTable", "Snapshot", "load", "repeated", "save"]


@dataclass(frozen=True)
class Snapshot:
    """One state of a rope whose axis is z, or was z before it was bent over a sheave.

    A yarn that is a solid over a stretch has its whole centre line all the same: there the mean of
    its sections.

    Raises:
        ValueError: If the arrays do not belong to the same yarns and nodes.
    """

    name: str
    centre_lines: tuple[Array, ...]  # per yarn (n_i, 3), mm
    radius: Array  # (num_yarns,), mm
    strand: Integers  # (num_yarns,), strand of each yarn
    directors: tuple[Array, ...] | None = None  # per yarn (n_i, 2, 3), section vectors g1, g2
    tension: tuple[Array, ...] | None = None  # per yarn (n_i - 1,), N, per segment
    axial_stress: tuple[Array, ...] | None = None  # per yarn (n_i - 1,), MPa, per segment
    contacts: ContactTable | None = None
    core: CoreLine | None = None
    skins: tuple[SkinPicture, ...] = ()  # surfaces of what is modelled as a solid
    sheave: SheavePicture | None = None
    force: float | None = None  # kN on the rope in this state, tension positive

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
        owners = [int(skin.owner.max()) for skin in self.skins if len(skin.owner)]
        if owners and max(owners) >= len(nodes):
            raise ValueError(
                f"Snapshot {self.name!r}: a skin of yarn {max(owners)} of {len(nodes)} yarns."
            )

    @property
    def num_yarns(self) -> int:
        return len(self.centre_lines)

    @property
    def state(self) -> str:
        """What titles and results call the state: its name, and the force on the rope where that is known.

        A state that is named by the force that was asked for is called by the force that there is.
        """
        if self.force is None:
            return self.name
        force = f"{self.force:.4g} kN"
        return force if self.name.endswith("kN") else f"{self.name}, {force}"

    @property
    def is_pulled(self) -> bool:
        """Whether a pull of the straight rope ended in this state: it is named by its force or strain."""
        named = self.name.endswith(("kN", "strain"))
        return named and self.axial_stress is not None and self.sheave is None


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

    core = snapshot.core
    return replace(
        snapshot,
        centre_lines=tuple(nodal(line, shifts) for line in snapshot.centre_lines),
        directors=snapshot.directors
        and tuple(nodal(pair, np.zeros(times)) for pair in snapshot.directors),
        tension=each(snapshot.tension),
        axial_stress=each(snapshot.axial_stress),
        contacts=snapshot.contacts and repeated_contacts(snapshot.contacts, shifts),
        core=core and replace(core, line=nodal(core.line, shifts)),
        skins=tuple(
            replace(skin, points=skin.points + shift) for shift in shifts for skin in snapshot.skins
        ),
    )


_PER_YARN = ("centre_lines", "directors", "tension", "axial_stress")


def save(snapshot: Snapshot, path: Path) -> None:
    """Write a snapshot as compressed npz; the file appears whole or not at all."""
    counts = [len(line) for line in snapshot.centre_lines]
    arrays: dict[str, Any] = {
        "name": snapshot.name,
        "counts": np.array(counts, dtype=np.int64),
        "radius": snapshot.radius,
        "strand": snapshot.strand,
    }
    for key in _PER_YARN:
        value = getattr(snapshot, key)
        if value is not None:
            arrays[key] = np.concatenate(value)
    arrays |= columns("contacts", snapshot.contacts)
    arrays |= columns("core", snapshot.core)
    arrays |= columns("sheave", snapshot.sheave)
    if snapshot.force is not None:
        arrays["force"] = snapshot.force
    for number, skin in enumerate(snapshot.skins):
        arrays |= columns(f"skin{number}", skin)
    part = path.with_name(path.name + ".part")
    with part.open("wb") as stream:
        np.savez_compressed(stream, **arrays)
    os.replace(part, path)


def load(path: Path) -> Snapshot:
    """Read a snapshot written by `save`; of older files, what they do not have stays empty."""
    with np.load(path) as data:
        counts = data["counts"]
        per_yarn: dict[str, tuple[Array, ...]] = {}
        for key in _PER_YARN:
            if key in data:
                lengths = counts - 1 if key in ("tension", "axial_stress") else counts
                per_yarn[key] = tuple(np.split(data[key], np.cumsum(lengths)[:-1]))
        skins: list[SkinPicture] = []
        while f"skin{len(skins)}_points" in data:
            skins.append(SkinPicture(**read_columns(f"skin{len(skins)}", SkinPicture, data)))
        contacts = read_columns("contacts", ContactTable, data)
        core, sheave = read_columns("core", CoreLine, data), read_columns(
            "sheave", SheavePicture, data
        )
        return Snapshot(
            name=str(data["name"]),
            centre_lines=per_yarn["centre_lines"],
            radius=data["radius"],
            strand=data["strand"],
            directors=per_yarn.get("directors"),
            tension=per_yarn.get("tension"),
            axial_stress=per_yarn.get("axial_stress"),
            contacts=ContactTable(**contacts) if contacts else None,
            core=CoreLine(**core) if core else None,
            skins=tuple(skins),
            sheave=SheavePicture(**sheave) if sheave else None,
            force=float(data["force"]) if "force" in data else None,
        )
