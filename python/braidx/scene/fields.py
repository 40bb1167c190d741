"""Fields of a scene: one table gives validation, defaults, documentation and schema.

Every option of a scene is a field of a frozen dataclass made with `option`; its unit, range and
meaning are stored with it, and `Table` checks them whenever an instance is made, from TOML or from
Python.
"""

from __future__ import annotations

import dataclasses
import functools
import math
import numbers
import re
import types
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar, Union, get_args, get_origin, get_type_hints

from braidx.scene.errors import SceneError, nearest

# Of numbers, whatever their unit: fourth powers, and quotients of these, stay within floats, which end at 1e308.
LARGEST, SMALLEST = 1e30, 1e-30
UNWRITABLE = re.compile("[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff]")  # no text file has such characters


@dataclass(frozen=True)
class Spec:
    """What a field means and which values it takes."""

    doc: str
    unit: str = "-"
    above: float | None = None  # exclusive lower bound
    minimum: float | None = None
    below: float | None = None  # exclusive upper bound
    maximum: float | None = None
    choices: tuple[Any, ...] = ()
    pattern: str = ""  # regular expression a text must match
    example: str = ""  # how such a text looks
    shortest: int = 0  # fewest entries of a list
    keys: tuple[str, ...] = ()  # names that the entries of a table may have; empty: any
    needs: str = ""  # what the option has no effect without, by its name in effects.py

    def range_text(self) -> str:
        """The range in words, empty where every value is allowed."""
        names = {"above": self.above, "at least": self.minimum}
        names |= {"below": self.below, "at most": self.maximum}
        return " and ".join(
            f"{name} {bound:g}" for name, bound in names.items() if bound is not None
        )


def option(default: Any = dataclasses.MISSING, *, doc: str, unit: str = "-", **limits: Any) -> Any:
    """A field of a scene with its unit, range and meaning (see `Spec`)."""
    metadata = {"spec": Spec(doc=doc, unit=unit, **limits)}
    if isinstance(default, (dict, list)):
        return dataclasses.field(default_factory=lambda: type(default)(default), metadata=metadata)
    return dataclasses.field(default=default, metadata=metadata)


@dataclass(frozen=True)
class Table:
    """Base of the scene's tables. Raises SceneError when a value does not fit its field."""

    table: ClassVar[str] = ""

    def __post_init__(self) -> None:
        own: Any = type(self)
        hints = type_hints(own)
        for field in dataclasses.fields(self):
            if getattr(self, field.name) is None and field.default is None:
                continue  # left out: the scene, or what uses it, decides
            key = f"{self.table}.{field.name}" if self.table else field.name
            value = convert(getattr(self, field.name), hints[field.name], spec_of(field), key)
            object.__setattr__(self, field.name, value)


# Resolved types of the fields of a dataclass, by name; worked out once per class.
type_hints: Callable[[Any], dict[str, Any]] = functools.cache(get_type_hints)


def spec_of(field: dataclasses.Field[Any]) -> Spec:
    """Meaning and range of a field made with `option`."""
    spec = field.metadata["spec"]
    assert isinstance(spec, Spec)
    return spec


def members(hint: Any) -> tuple[Any, ...]:
    """The members of a union type, else the type itself."""
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


def type_text(hint: Any, plural: bool = False) -> str:
    """A type in words."""
    names = {float: "number", int: "whole number", bool: "true or false", str: "text"}
    parts = [part for part in members(hint) if part is not type(None)]
    if len(parts) > 1:
        return " or ".join(type_text(part, plural) for part in parts)
    plural_mark = "s" if plural else ""
    if get_origin(parts[0]) is tuple:
        return f"list{plural_mark} of {type_text(get_args(parts[0])[0], plural=True)}"
    return names.get(parts[0], "table") + plural_mark


def convert(value: Any, hint: Any, spec: Spec, key: str) -> Any:
    """A value as its field's type wants it, checked against the field's range.

    Raises:
        SceneError: If type or range is wrong.
    """
    # A value that is of one of several types is of that one: 80 stays whole where numbers may be either.
    for member in sorted(members(hint), key=lambda member: type(value) is not member):
        if member is type(None) and value is None:
            return None
        if _fits(value, member):
            return _checked(value, member, spec, key)
    entries = f" of {', '.join(spec.keys)}, each {spec.example or 'a number'}" if spec.keys else ""
    raise SceneError(key, f"wrong type, give a {type_text(hint)}{entries}{in_unit(spec)}.", value)


def _fits(value: Any, hint: Any) -> bool:
    if hint in (float, int):
        kind = numbers.Real if hint is float else numbers.Integral
        return isinstance(value, kind) and not isinstance(value, bool)
    if get_origin(hint) is tuple:
        entry = get_args(hint)[0]
        return isinstance(value, (list, tuple)) and all(_fits(each, entry) for each in value)
    if get_origin(hint) is dict:
        kinds = members(get_args(hint)[1])
        return isinstance(value, dict) and all(
            isinstance(name, str) and any(_fits(each, kind) for kind in kinds)
            for name, each in value.items()
        )
    return isinstance(value, hint)


def _checked(value: Any, hint: Any, spec: Spec, key: str) -> Any:
    if get_origin(hint) is tuple:
        if len(value) < max(spec.shortest, 1) and spec.shortest:
            raise SceneError(key, f"too short, give at least {spec.shortest} entries.", value)
        entry = get_args(hint)[0]
        return tuple(_checked(each, entry, spec, f"{key}[{i}]") for i, each in enumerate(value))
    if get_origin(hint) is dict:
        return _checked_entries(value, hint, spec, key)
    if hint in (float, int):
        value = _number(value, hint, key)
        _check_range(value, spec, key)
    if isinstance(value, str):
        _check_text(value, spec, key)
    return value


def _checked_entries(value: dict[str, Any], hint: Any, spec: Spec, key: str) -> dict[str, Any]:
    for name in value:
        _check_writable(name, key)
        if spec.keys and name not in spec.keys:
            raise SceneError(f"{key}.{name}", f"unknown key; {nearest(name, spec.keys)}")
    single = dataclasses.replace(spec, keys=())
    kinds = get_args(hint)[1]
    return {name: convert(each, kinds, single, f"{key}.{name}") for name, each in value.items()}


def _number(value: Any, hint: type, key: str) -> Any:
    """A number as float or int, of a size that can be computed with."""
    if abs(value) > LARGEST and not (isinstance(value, float) and math.isinf(value)):
        raise SceneError(key, f"too large, no number may be beyond {LARGEST:g}.", value)
    if 0 < abs(value) < SMALLEST:
        raise SceneError(key, f"too small, write 0 or at least {SMALLEST:g}.", value)
    return hint(value)


def _check_writable(text: str, key: str) -> None:
    if UNWRITABLE.search(text):
        raise SceneError(key, "has a character that is no text; leave it out.", text)


def _check_range(value: float, spec: Spec, key: str) -> None:
    wrong = math.isnan(value) or math.isinf(value)
    wrong |= spec.above is not None and not value > spec.above
    wrong |= spec.minimum is not None and value < spec.minimum
    wrong |= spec.below is not None and not value < spec.below
    wrong |= spec.maximum is not None and value > spec.maximum
    numbers = [choice for choice in spec.choices if not isinstance(choice, str)]
    if numbers and value not in numbers:
        raise SceneError(key, f"choose {' or '.join(map(str, numbers))}.", value)
    if wrong:
        wanted = " and ".join(text for text in ("finite", spec.range_text()) if text)
        raise SceneError(key, f"out of range, must be {wanted}{_unit_text(spec)}.", value)


def _check_text(value: str, spec: Spec, key: str) -> None:
    _check_writable(value, key)
    texts = [choice for choice in spec.choices if isinstance(choice, str)]
    if texts and value not in texts and not spec.pattern:
        cure = nearest(value, texts)
        raise SceneError(key, f"choose {' or '.join(texts)}; {cure}", value)
    if spec.pattern and value not in texts and not re.fullmatch(spec.pattern, value):
        raise SceneError(key, f"not understood, write it as {spec.example}.", value)


def in_unit(spec: Spec) -> str:
    """The unit after a comma, empty where there is none."""
    return "" if spec.unit == "-" else f", in {spec.unit}"


def _unit_text(spec: Spec) -> str:
    return "" if spec.unit == "-" else f" {spec.unit}"
