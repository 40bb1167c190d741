"""Whether two scenes have the same results, and if not, why."""

from __future__ import annotations

from typing import Any

from braidx.scene.errors import NO_VALUE, toml_text
from braidx.scene.scene import Scene
from braidx.scene.write import to_dict


def difference(scene: Scene, other: Scene) -> str:
    """First difference between two scenes that changes their results, empty where there is none.

    What is written and what is expected do not count.
    """
    one, two = to_dict(scene), to_dict(other)
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
