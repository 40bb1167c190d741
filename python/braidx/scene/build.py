"""From nested dictionaries, as TOML gives them, to the dataclasses of a scene."""

from __future__ import annotations

import dataclasses
from typing import Any, TypeVar

from braidx.scene.accuracy import completed
from braidx.scene.core import Core
from braidx.scene.ends import EndConditions, EndGroup
from braidx.scene.errors import SceneError, nearest
from braidx.scene.fields import Spec, Table, convert, in_unit, spec_of
from braidx.scene.heat import Heat
from braidx.scene.material import Material, YarnModel
from braidx.scene.numerics import (
    ContactOptions,
    Expected,
    OutputOptions,
    SolverOptions,
)
from braidx.scene.recipe import BraidRecipe, RopeRecipe, StrandRecipe
from braidx.scene.scene import Scene
from braidx.scene.sheave import Sheave
from braidx.scene.step import Step
from braidx.scene.steps import STEPS

T = TypeVar("T", bound=Table)

TABLES: dict[str, type[Table]] = {
    cls.table: cls
    for cls in (
        RopeRecipe,
        BraidRecipe,
        StrandRecipe,
        Core,
        Sheave,
        YarnModel,
        ContactOptions,
        SolverOptions,
        EndConditions,
        OutputOptions,
        Heat,
    )
}
NAMED: dict[str, type[Table]] = {"material": Material, "expected": Expected}
REQUIRED = ("rope", "yarn")
KIND = Spec(doc="Which step it is.", choices=tuple(STEPS))


def scene_from_dict(data: dict[str, Any], name: str = "") -> Scene:
    """Build a scene.

    Args:
        data: Tables by name, as `tomllib` returns them; not changed.
        name: Name of the scene where [rope] gives none.
    Raises:
        SceneError: If a key is unknown or missing or a value is wrong.
    """
    scene = _as_stated(data, name)
    return _as_stated(completed(scene, data), name) if scene.solver.accuracy else scene


def _as_stated(data: dict[str, Any], name: str) -> Scene:
    """The scene of these tables and the defaults."""
    data = _entries(data, "scene")
    _check_keys(data, {*TABLES, *NAMED, "steps"}, "")
    tables = {key: _entries(value, key) for key, value in data.items() if key in TABLES}
    for required in REQUIRED:
        if required not in tables:
            raise SceneError(required, f"table missing, add [{required}].")
    if tables["rope"].get("name", "") == "":
        tables["rope"]["name"] = name
    named = {
        group: {
            each: table_from_dict(cls, _entries(value, f"{group}.{each}"), f"{group}.{each}")
            for each, value in _entries(data.get(group, {}), group).items()
        }
        for group, cls in NAMED.items()
    }
    _take_material(tables["yarn"], named["material"])
    if "groups" in tables.get("ends", {}):
        tables["ends"]["groups"] = _groups(tables["ends"]["groups"])
    built = {key: table_from_dict(TABLES[key], entries, key) for key, entries in tables.items()}
    arguments: dict[str, Any] = {**built, **named, "steps": _steps(data.get("steps", []))}
    return Scene(**arguments)


def table_from_dict(cls: type[T], entries: dict[str, Any], where: str) -> T:
    """Build one table; errors name it `where`."""
    known = {field.name: field for field in dataclasses.fields(cls)}
    _check_keys(entries, set(known), where)
    for field in known.values():
        no_default = field.default is field.default_factory is dataclasses.MISSING
        if no_default and field.name not in entries:
            cure = f"missing, add it{in_unit(spec_of(field))}."
            raise SceneError(f"{where}.{field.name}", cure)
    try:
        return cls(**entries)
    except SceneError as error:
        raise error.renamed(error.key.replace(cls.table, where, 1)) from None


def _steps(data: Any) -> tuple[Step, ...]:
    if not isinstance(data, list):
        raise SceneError("steps", "write each step as a table [[steps]].")
    steps = []
    for i, step in enumerate(data):
        where = f"steps[{i}]"
        entries = _entries(step, where)
        kind = entries.pop("kind", None)
        if kind is None:
            raise SceneError(f"{where}.kind", f"missing, choose {' or '.join(STEPS)}.")
        kind = convert(kind, str, KIND, f"{where}.kind")
        steps.append(table_from_dict(STEPS[kind], entries, where))
    return tuple(steps)


def _groups(data: Any) -> tuple[EndGroup, ...]:
    if not isinstance(data, list):
        raise SceneError("ends.groups", "write each group as a table [[ends.groups]].", data)
    names = (f"ends.groups[{i}]" for i in range(len(data)))
    return tuple(
        table_from_dict(EndGroup, _entries(group, name), name)
        for group, name in zip(data, names, strict=False)
    )


def _take_material(yarn: dict[str, Any], materials: dict[str, Any]) -> None:
    """Fill a yarn's values from the material it names; its own values win."""
    name = yarn.get("material", "")
    if not isinstance(name, str) or not name:
        return  # the yarn's own check refuses what is no text
    if name not in materials:
        cure = nearest(str(name), materials)
        raise SceneError("yarn.material", f"no table [material.{name}]; {cure}", name)
    values = {key: value for key, value in vars(materials[name]).items() if value is not None}
    modulus = values.pop("axial_modulus", None)
    for key, value in values.items():
        yarn.setdefault(key, value)
    if modulus is not None and "axial_stiffness" not in yarn:
        sized = {key: yarn[key] for key in ("radius", "area") if key in yarn}
        yarn["axial_stiffness"] = modulus * table_from_dict(YarnModel, sized, "yarn").section_area


def _entries(value: Any, where: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise SceneError(where, f"wrong type, write it as a table [{where}].", value)
    return dict(value)


def _check_keys(entries: dict[str, Any], known: set[str], where: str) -> None:
    for key in entries:
        if key not in known:
            name = f"{where}.{key}" if where else key
            what = "key" if where else "table"
            raise SceneError(name, f"unknown {what}; {nearest(key, known)}")
