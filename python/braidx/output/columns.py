"""Dataclasses of arrays as entries of an npz file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any


def columns(prefix: str, item: Any) -> dict[str, Any]:
    """The fields of a dataclass as entries `prefix_field`; nothing for a field that is None.

    `item` itself may be None, which gives no entries.
    """
    if item is None:
        return {}
    values = {entry.name: getattr(item, entry.name) for entry in fields(item)}
    return {f"{prefix}_{name}": value for name, value in values.items() if value is not None}


def read_columns(prefix: str, kind: type, data: Mapping[str, Any]) -> dict[str, Any]:
    """The fields of a dataclass that the file has, single numbers as such; none gives {}."""
    found: dict[str, Any] = {}
    for entry in fields(kind):
        key = f"{prefix}_{entry.name}"
        if key in data:
            value = data[key]
            found[entry.name] = value if value.ndim else value.item()
    return found
