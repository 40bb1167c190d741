"""Scenes as TOML: read with overrides, written whole, and compared."""

from __future__ import annotations

import dataclasses
import json
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from braidx.scene.build import scene_from_dict
from braidx.scene.errors import NO_VALUE, SceneError, toml_text
from braidx.scene.scene import Scene
from braidx.scene.steps import Step


def load_scene(path: str | Path, overrides: Iterable[str] = ()) -> Scene:
    """Read a scene.

    Args:
        path: TOML file.
        overrides: Texts "table.key=value"; a value is written as in TOML, the quotes of a text
            may be left out. A step is named by its kind or its number: "steps.pull.to_force=20".
    Raises:
        SceneError: If anything is wrong; it names the file.
    """
    path = Path(path)
    try:
        data = _read(path)
        for override in overrides:
            apply_override(data, override)
        return scene_from_dict(data, name=path.stem)
    except SceneError as error:
        raise error.within(str(path)) from None


def _read(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        raise SceneError("", "no such file; give the path of a scene (*.toml).") from None
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not a text file"
        raise SceneError("", f"cannot be read ({reason}); give a scene (*.toml).") from None
    except tomllib.TOMLDecodeError as error:
        raise SceneError("", f"not valid TOML: {error}") from None


def apply_override(data: dict[str, Any], override: str) -> None:
    """Set one value in nested tables, in place."""
    key, equals, text = override.partition("=")
    path = key.strip().split(".")
    if not equals or len(path) < 2 or not all(path):
        raise SceneError(f"--set {override}", "write table.key=value, such as yarn.model=beam.")
    value = _parse(text.strip())
    for table in _tables(data, path[:-1], key.strip()):
        table[path[-1]] = value


def _parse(text: str) -> Any:
    try:
        values = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return text
    return values["value"] if len(values) == 1 else text


def _tables(data: dict[str, Any], path: list[str], key: str) -> Iterator[dict[str, Any]]:
    tables: list[Any] = [data]
    for name in path:
        below: list[Any] = []
        for table in tables:
            if isinstance(table, list):
                below += _steps(table, name, key)
            elif isinstance(table, dict):
                below.append(table.setdefault(name, {}))
            else:
                raise SceneError(f"--set {key}", f"'{name}' is inside a value, not a table.")
        tables = below
    for table in tables:
        if not isinstance(table, dict):
            raise SceneError(f"--set {key}", "name the step too, such as steps.pull.to_force=20.")
        yield table


def _steps(steps: list[Any], name: str, key: str) -> list[Any]:
    kinds = [step.get("kind") if isinstance(step, dict) else None for step in steps]
    found = [step for i, step in enumerate(steps) if name in (str(i), kinds[i])]
    if not found:
        raise SceneError(
            f"--set {key}", f"no step '{name}'; the scene has {', '.join(map(str, kinds))}."
        )
    return found


def to_dict(scene: Scene) -> dict[str, Any]:
    """The scene as nested dictionaries, values that are left out left out."""

    def entries(table: Any) -> dict[str, Any]:
        pairs = ((field.name, getattr(table, field.name)) for field in dataclasses.fields(table))
        found = {key: value for key, value in pairs if value is not None}
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
            blocks.append(_block(f"[{name}]", value))
    return "\n".join(blocks)


def _block(header: str, entries: dict[str, Any]) -> str:
    lines = [f"{_key(key)} = {_value(value)}" for key, value in entries.items()]
    return "\n".join([header, *lines, ""])


def _key(key: str) -> str:
    return (
        key
        if key.replace("_", "a").replace("-", "a").isalnum() and key.isascii()
        else json.dumps(key)
    )


def _value(value: Any) -> str:
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items()) + "}"
    return repr(value)


def difference(scene: Scene, other: Scene) -> str:
    """First difference between two scenes that changes their results, empty where there is none.

    What is written, what is expected and the number of threads do not count.
    """
    one, two = to_dict(scene), to_dict(other)
    for tables in (one, two):
        tables["solver"].pop("threads")
    for name in [key for key in {**one, **two} if key not in ("output", "expected")]:
        if one.get(name) != two.get(name):
            return _first_difference(name, one.get(name, {}), two.get(name, {}))
    return ""


def _first_difference(name: str, one: Any, two: Any) -> str:
    if isinstance(one, list) and isinstance(two, list) and len(one) == len(two):
        one, two = dict(enumerate(one)), dict(enumerate(two))
    if not (isinstance(one, dict) and isinstance(two, dict)):
        if isinstance(one, list):
            return f"{name}: {len(one)} here, {len(two)} there"
        here, there = (toml_text(v) if v is not NO_VALUE else "left out" for v in (one, two))
        return f"{name}: {here} here, {there} there"
    key = next(key for key in {**one, **two} if one.get(key, NO_VALUE) != two.get(key, NO_VALUE))
    return _first_difference(f"{name}.{key}", one.get(key, NO_VALUE), two.get(key, NO_VALUE))
