"""Scenes from TOML files, with values replaced on the command line."""

from __future__ import annotations

import logging
import os
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from braidx.scene.build import scene_from_dict
from braidx.scene.effects import NoEffect
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene

LOGGER = logging.getLogger("braidx")
# tomllib also raises what Python does for whole numbers that are too long, and for lists nested too deep.
TOML_ERRORS = (ValueError, RecursionError)


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
        data, replaced = _read(path), list(overrides)
        for override in replaced:
            apply_override(data, override)
        _place_mesh(data, path.parent)
        return _with_effect(data, path.stem, replaced)
    except SceneError as error:
        raise error.within(str(path)) from None


def _with_effect(data: dict[str, Any], name: str, overrides: list[str]) -> Scene:
    """The scene, without what the file states and what is set on the command line takes the effect from."""
    named = {override.partition("=")[0].strip() for override in overrides}
    while True:
        try:
            return scene_from_dict(data, name=name)
        except NoEffect as error:
            table, _, key = error.key.partition(".")
            if not overrides or error.key in named or key not in data.get(table, {}):
                raise
            del data[table][key]
            LOGGER.warning("%s; it is left out, for --set %s", error, " --set ".join(overrides))


def _place_mesh(data: dict[str, Any], folder: Path) -> None:
    """Make the path of a mesh one that holds in any folder."""
    core = data.get("core")
    if isinstance(core, dict) and isinstance(core.get("mesh"), str) and core["mesh"]:
        core["mesh"] = os.path.abspath(folder / core["mesh"])


def _read(path: Path) -> dict[str, Any]:
    try:
        text = path.read_text("utf-8")
    except FileNotFoundError:
        raise SceneError("", "no such file; give the path of a scene (*.toml).") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not a text file"
        raise SceneError("", f"cannot be read ({reason}); give a scene (*.toml).") from None
    try:
        return tomllib.loads(text)
    except TOML_ERRORS as error:
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
    except TOML_ERRORS:
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
        if isinstance(table, list):
            raise SceneError(f"--set {key}", "name the step too, such as steps.pull.to_force=20.")
        if not isinstance(table, dict):
            raise SceneError(f"--set {key}", f"'{path[-1]}' is a value, not a table.")
        yield table


def _steps(steps: list[Any], name: str, key: str) -> list[Any]:
    kinds = [step.get("kind") if isinstance(step, dict) else None for step in steps]
    found = [step for i, step in enumerate(steps) if name in (str(i), kinds[i])]
    if not found:
        raise SceneError(
            f"--set {key}", f"no step '{name}'; the scene has {', '.join(map(str, kinds))}."
        )
    return found
