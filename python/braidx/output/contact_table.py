"""Contact elements of one state as columns of a table."""

from __future__ import annotations

from dataclasses import dataclass, field, fields

import numpy as np
from numpy.typing import NDArray

from braidx.output.arrays import Array, Integers

YARN_YARN, YARN_CORE, YARN_SHEAVE, CORE_SHEAVE = range(4)
KINDS = ("yarn on yarn", "yarn on core", "yarn on sheave", "core on sheave")
_VECTORS = ("position", "normal", "friction_force")
_LATER = ("kind", "measure", "per_area")  # columns that older files lack


@dataclass(frozen=True)
class ContactTable:
    """Contact elements of one state, one row each (m rows).

    Normals point from a to b; a negative gap is a penetration. The last three columns may be left
    empty: the contacts are then between yarns, and what an element stands for is not known (NaN).
    """

    position: Array  # (m, 3), mm
    normal: Array  # (m, 3), unit vectors from a to b
    gap: Array  # (m,), mm
    normal_force: Array  # (m,), N, positive in compression
    friction_force: Array  # (m, 3), N, on b
    reversible_slip: (
        Array  # (m,), mm: the elastic part of the slip, which the friction force follows
    )
    work: Array  # (m,), mJ, dissipated by friction by this element; contacts that have ended count in none
    yarn_a: Integers  # (m,); -1 where a is the core
    yarn_b: Integers  # (m,); -1 where b is the core or the sheave
    kind: Integers = field(default_factory=lambda: np.empty(0, dtype=np.int64))  # (m,), of KINDS
    # (m,), mm or mm^2: what the element stands for; an area where `per_area`
    measure: Array = field(default_factory=lambda: np.empty(0))
    per_area: NDArray[np.bool_] = field(default_factory=lambda: np.empty(0, dtype=bool))

    def __post_init__(self) -> None:
        rows = len(self.gap)
        defaults = (
            np.zeros(rows, dtype=np.int64),
            np.full(rows, np.nan),
            np.zeros(rows, dtype=bool),
        )
        for name, default in zip(_LATER, defaults):
            if np.size(getattr(self, name)) == 0:
                object.__setattr__(self, name, default)
        for entry in fields(self):
            value = np.asarray(getattr(self, entry.name))
            expected = (rows, 3) if entry.name in _VECTORS else (rows,)
            if value.shape != expected:
                raise ValueError(f"ContactTable.{entry.name}: {value.shape}, expected {expected}.")
        if rows and not 0 <= self.kind.min() <= self.kind.max() < len(KINDS):
            raise ValueError(f"ContactTable.kind: give numbers from 0 to {len(KINDS) - 1}.")

    def of(self, kind: int) -> ContactTable:
        """The rows of one kind."""
        chosen = self.kind == kind
        return ContactTable(**{f.name: getattr(self, f.name)[chosen] for f in fields(self)})


def repeated_contacts(table: ContactTable, shifts: Array) -> ContactTable:
    """The table once per shift, shape (times, 3) mm, moved by it."""
    columns = {
        entry.name: np.concatenate([getattr(table, entry.name)] * len(shifts))
        for entry in fields(ContactTable)
    }
    columns["position"] = np.concatenate([table.position + shift for shift in shifts])
    return ContactTable(**columns)
