"""The scene reference, written from the dataclasses: Markdown for people, JSON schema for tools."""

from __future__ import annotations

import dataclasses
import inspect
import re
from typing import Any, get_args, get_origin

from braidx.scene.build import NAMED, REQUIRED, TABLES
from braidx.scene.effects import NEEDS
from braidx.scene.ends import EndGroup
from braidx.scene.errors import toml_text
from braidx.scene.fields import Spec, Table, members, spec_of, type_hints, type_text
from braidx.scene.steps import STEPS

INTRODUCTION = """\
# Scene reference

A scene is a TOML file. Lengths are in mm, forces in N (rope forces in kN), stresses in MPa. A key
that is left out takes its default; an unknown key is an error, and so is a value that changes
nothing in its scene. On the command line `--set table.key=value` replaces a value,
`--set steps.pull.to_force=20` one of a step.

This page is written by `braidx schema --markdown` from the dataclasses in `braidx.scene`.
"""


def markdown() -> str:
    """The reference page of all tables and steps, as committed in docs/scene_reference.md."""
    parts = [INTRODUCTION]
    for name, cls in TABLES.items():
        parts.append(_section(f"[{name}]", cls))
    parts.append(_section("[[ends.groups]]", EndGroup))
    for name, cls in NAMED.items():
        parts.append(_section(f"[{name}.NAME]", cls))
    parts.append("## [[steps]]\n\nOne table per step, in order; `kind` says which step it is.\n")
    for kind, step in STEPS.items():
        parts.append(_section(f'kind = "{kind}"', step, level=3))
    return "\n".join(parts)


def _section(title: str, cls: type, level: int = 2) -> str:
    doc = inspect.cleandoc(cls.__doc__ or "")
    lines = [f"{'#' * level} {title}", "", doc, ""]
    lines += ["| key | type | unit | default | range | meaning |", "| --- " * 6 + "|"]
    for field in dataclasses.fields(cls):
        spec, hint = spec_of(field), type_hints(cls)[field.name]
        cells = [f"`{field.name}`", type_text(hint), spec.unit, _default_text(field)]
        acts = f" Acts on {NEEDS[spec.needs].only}." if spec.needs else ""
        cells += [_range_text(spec), spec.doc + acts]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join([*lines, ""])


def _default(field: dataclasses.Field[Any]) -> Any:
    if field.default_factory is not dataclasses.MISSING:
        return field.default_factory()
    return field.default


def _default_text(field: dataclasses.Field[Any]) -> str:
    default = _default(field)
    if default is dataclasses.MISSING:
        return "required"
    return "left out" if default is None else f"`{toml_text(default)}`"


def _range_text(spec: Spec) -> str:
    choices = [f"`{toml_text(choice)}`" for choice in spec.choices]
    if spec.pattern:
        choices.append(spec.example)
    if spec.keys:
        return f"entries {', '.join(f'`{key}`' for key in spec.keys)}: {choices[-1] if choices else 'numbers'}"
    return "; ".join(text for text in (spec.range_text(), ", ".join(choices)) if text)


def json_schema() -> dict[str, Any]:
    """JSON schema of a scene, for editors that check TOML while it is written."""
    properties = {name: _object(cls) for name, cls in TABLES.items()}
    properties |= {
        name: {"type": "object", "additionalProperties": _object(cls)}
        for name, cls in NAMED.items()
    }
    steps = []
    for kind, cls in STEPS.items():
        step = _object(cls)
        step["properties"] = {"kind": {"const": kind}, **step["properties"]}
        step["required"] = ["kind", *step.get("required", [])]
        steps.append(step)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "braidx scene",
        "type": "object",
        "additionalProperties": False,
        "required": list(REQUIRED),
        "properties": {**properties, "steps": {"type": "array", "items": {"oneOf": steps}}},
    }


def _object(cls: type) -> dict[str, Any]:
    properties, required = {}, []
    for field in dataclasses.fields(cls):
        spec, default = spec_of(field), _default(field)
        kinds = [part for part in members(type_hints(cls)[field.name]) if part is not type(None)]
        schemas = [_type_schema(kind, spec) for kind in kinds]
        entry = schemas[0] if len(schemas) == 1 else {"anyOf": schemas}
        unit = "" if spec.unit == "-" else f" Unit: {spec.unit}."
        entry = {**entry, "description": spec.doc + unit}
        if default is dataclasses.MISSING:
            required.append(field.name)
        elif default is not None:
            entry["default"] = list(default) if isinstance(default, tuple) else default
        properties[field.name] = entry
    doc = re.sub(r"\s+", " ", (cls.__doc__ or "").strip())
    table = {"type": "object", "description": doc, "additionalProperties": False}
    return {**table, "properties": properties, **({"required": required} if required else {})}


def _type_schema(hint: Any, spec: Spec) -> dict[str, Any]:
    if get_origin(hint) is tuple:
        inner = dataclasses.replace(spec, shortest=0)
        schema: dict[str, Any] = {"type": "array", "items": _type_schema(get_args(hint)[0], inner)}
        return {**schema, "minItems": spec.shortest} if spec.shortest else schema
    if get_origin(hint) is dict:
        return _entries_schema(hint, spec)
    if isinstance(hint, type) and issubclass(hint, Table):
        return _object(hint)
    if hint is bool:
        return {"type": "boolean"}
    if hint is str:
        texts = [choice for choice in spec.choices if isinstance(choice, str)]
        if spec.pattern:
            pattern = "|".join([*map(re.escape, texts), spec.pattern])
            return {"type": "string", "pattern": f"^({pattern})$"}
        return {"type": "string", **({"enum": texts} if texts else {})}
    schema = {"type": "integer" if hint is int else "number"}
    bounds = {"exclusiveMinimum": spec.above, "minimum": spec.minimum}
    bounds |= {"exclusiveMaximum": spec.below, "maximum": spec.maximum}
    numbers = [choice for choice in spec.choices if not isinstance(choice, str)]
    found = {key: bound for key, bound in bounds.items() if bound is not None}
    return {**schema, **found, **({"enum": numbers} if numbers else {})}


def _entries_schema(hint: Any, spec: Spec) -> dict[str, Any]:
    """Schema of a table of values, whose names are known if `spec` has keys."""
    if not spec.keys:
        return {"type": "object"}
    single = dataclasses.replace(spec, keys=())
    kinds = [_type_schema(kind, single) for kind in members(get_args(hint)[1])]
    value = kinds[0] if len(kinds) == 1 else {"anyOf": kinds}
    properties = {key: value for key in spec.keys}
    return {"type": "object", "additionalProperties": False, "properties": properties}
