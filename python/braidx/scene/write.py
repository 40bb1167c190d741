"""Scenes as TOML, every default written out."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

from braidx.scene.scene import Scene
from braidx.scene.step import Step


def to_dict(scene: Scene) -> dict[str, Any]:
    """The scene as nested dictionaries, values that are left out left out."""

    def plain(value: Any) -> Any:
        nested = isinstance(value, tuple) and value and dataclasses.is_dataclass(value[0])
        return [entries(each) for each in value] if nested else value

    def entries(table: Any) -> dict[str, Any]:
        pairs = ((field.name, getattr(table, field.name)) for field in dataclasses.fields(table))
        found = {key: plain(value) for key, value in pairs if value is not None}
        return {"kind": table.kind, **found} if isinstance(table, Step) else found

    tables: dict[str, Any] = {}
    for field in dataclasses.fields(scene):
        value = getattr(scene, field.name)
        if isinstance(value, dict):
            tables[field.name] = {name: entries(table) for name, table in value.items()}
        elif isinstance(value, tuple):
            tables[field.name] = [entries(step) for step in value]
        elif value is not None:
            tables[field.name] = entries(value)
    return tables


def to_toml(scene: Scene) -> str:
    """The whole scene as TOML, every default written out; `load_scene` gives the same scene."""
    blocks = []
    for name, value in to_dict(scene).items():
        if name in ("material", "expected"):
            blocks += [_block(f"[{name}.{_key(each)}]", table) for each, table in value.items()]
        elif name == "steps":
            blocks += [_block("[[steps]]", step) for step in value]
        else:
            nested = {key for key, entry in value.items() if _is_tables(entry)}
            single = {key: entry for key, entry in value.items() if key not in nested}
            blocks.append(_block(f"[{name}]", single))
            blocks += [_block(f"[[{name}.{key}]]", each) for key in nested for each in value[key]]
    return "\n".join(blocks)


def _is_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _block(header: str, entries: dict[str, Any]) -> str:
    lines = [f"{_key(key)} = {_value(value)}" for key, value in entries.items()]
    return "\n".join([header, *lines, ""])


def _key(key: str) -> str:
    bare = key.replace("_", "a").replace("-", "a").isalnum() and key.isascii()
    return key if bare else _text(key)


def _text(value: str) -> str:
    # JSON writes characters beyond 65,535 as pairs that TOML does not have.
    return json.dumps(value, ensure_ascii=False)


def _value(value: Any) -> str:
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items()) + "}"
    return repr(value)
