"""Options for an accuracy that is asked for, out of what was measured (docs/accuracy.md)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from braidx.scene.bending import Bend, BendCycles, RunOver, Straighten
from braidx.scene.defaults import crossings, is_bundled, most_elements
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene
from braidx.scene.steps import Cycle, Pull

LEVELS = ("5%", "1%", "0.1%")


@dataclass(frozen=True)
class Choice:
    """What to use for one level of accuracy.

    Attributes:
        degree: Of the elements of yarns.
        elements: Of a yarn from crossing to crossing; of a strand without a braid: per eighth of a lay.
        station_spacing: Over the length of an element between nodes.
        penetration: Tolerance of penetrations over the radius.
        step: Strain per increment of a pull; travel of the ends per increment of bending, over the yarn's radius.
        reached: Largest error measured with these options or finer ones, as a fraction; more than the level where the
            level was not reached.
    """

    degree: int
    elements: float
    station_spacing: float
    penetration: float
    step: float
    reached: float


# By level, of ropes that are pulled and of ropes that are bent: the cheapest options measured that reach the level in
# tests/benchmark/accuracy_cost, whose test compares these numbers with the measured ones.
PULLED: Mapping[str, Choice] = {
    "5%": Choice(1, 2.0, 0.25, 0.015, 1e-3, 0.024),
    "1%": Choice(2, 3.0, 0.25, 0.015, 1e-3, 0.00999),
    "0.1%": Choice(1, 10.0, 0.25, 0.015, 1e-3, 0.0053),
}
BENT: Mapping[str, Choice] = {
    "5%": Choice(1, 6.0, 0.25, 0.005, 0.417, 0.0364),
    "1%": Choice(1, 10.0, 0.25, 0.0015, 0.417, 0.0081),
    "0.1%": Choice(1, 20.0, 0.25, 0.0015, 0.417, 0.0040),
}


def level_of(text: str) -> str:
    """The level that is at least as accurate as a text such as "2%" asks for.

    Raises:
        SceneError: If it asks for more than any, or for nothing.
    """
    number = re.fullmatch(r"\s*(\d*\.?\d+)\s*%\s*", text)
    asked = float(number[1]) if number else 0.0
    for level in LEVELS:
        if asked >= fraction(level) * 100.0 * (1.0 - 1e-9):
            return level
    known = ", ".join(LEVELS[:-1])
    raise SceneError("--accuracy", f"choose {known} or {LEVELS[-1]} (or what lies between).", text)


def fraction(level: str) -> float:
    """A level as a fraction, 0.01 for "1%"."""
    return float(level.rstrip("%")) / 100.0


def choice(scene: Scene, level: str) -> Choice:
    """The row of the table for a scene."""
    bends = any(isinstance(step, Bend) for step in scene.steps)
    row = (BENT if bends else PULLED)[level]
    # Bundles get as many nodes, of elements of degree 1.
    return replace(row, degree=1, elements=row.degree * row.elements) if is_bundled(scene) else row


def options(scene: Scene, level: str) -> dict[str, Any]:
    """What the table has for a scene, by dotted key; steps go by number."""
    row = choice(scene, level)
    most = most_elements(scene, row.degree)
    found = {
        "yarn.degree": row.degree,
        "yarn.elements_per_pitch": max(4, min(most, elements_of(scene, row))),
        "contact.station_spacing": row.station_spacing,
        "contact.penetration_tolerance": row.penetration,
    }
    return found | dict(_of_steps(scene, row.step))


def elements_of(scene: Scene, row: Choice) -> int:
    """Elements per pitch that a row asks for."""
    return math.ceil(row.elements * crossings(scene) - 1e-9)


def _of_steps(scene: Scene, step: float) -> Iterator[tuple[str, Any]]:
    """Sizes of increments, as the keys of the steps have them."""
    travel = 0.0
    for i, each in enumerate(scene.steps):
        if isinstance(each, (Pull, Cycle)):
            yield f"steps.{i}.strain_increment", step
        elif isinstance(each, (Bend, Straighten, BendCycles)):
            travel = each.travel if isinstance(each, Bend) else travel
            way = travel / (step * scene.yarn.radius)
            yield f"steps.{i}.increments", max(2, math.ceil(way - 1e-9))
        elif isinstance(each, RunOver):
            way = each.way / (step * scene.yarn.radius)
            yield f"steps.{i}.increments", max(2, math.ceil(way - 1e-9))


def attainable(scene: Scene, elements: int, degree: int) -> dict[str, Any]:
    """What the table has but for the penetration where elements are coarser than the table's.

    Chords of coarse elements cannot be kept apart to less than they are off their curves, and no equilibrium is found.
    """
    wanted, row = options(scene, scene.solver.accuracy), choice(scene, scene.solver.accuracy)
    coarse = elements * degree < elements_of(scene, row) * row.degree
    left_out = {"contact.penetration_tolerance"} if coarse else set()
    return {name: value for name, value in wanted.items() if name not in left_out}


def completed(scene: Scene, data: dict[str, Any]) -> dict[str, Any]:
    """Tables of a scene with the options of the accuracy that it asks for where they state nothing themselves.

    Args:
        scene: What the tables make without.
        data: The tables; not changed.
    """
    tables = {name: _copy(table) for name, table in data.items()}
    wanted, yarn = options(scene, scene.solver.accuracy), tables["yarn"]
    if "elements_per_pitch" in yarn:
        yarn.setdefault("degree", scene.yarn.degree)  # nodes stay as many as it states
    own = [yarn.get(name, wanted[f"yarn.{name}"]) for name in ("elements_per_pitch", "degree")]
    for name, value in attainable(scene, *own).items():
        *path, last = name.split(".")
        table: Any = tables.setdefault(path[0], {})
        if len(path) == 2:
            table = table[int(path[1])]
        table.setdefault(last, value)
    return tables


def _copy(table: Any) -> Any:
    if isinstance(table, list):
        return [_copy(each) for each in table]
    return dict(table) if isinstance(table, dict) else table


@dataclass(frozen=True)
class Followed:
    """What became of the accuracy that a scene asks for.

    Attributes:
        level: Asked for.
        chosen: Options that are as the table has them, by dotted key.
        stated: Options that the scene states otherwise.
        reached: See Choice.
    """

    level: str
    chosen: dict[str, Any]
    stated: dict[str, Any]
    reached: float


def followed(scene: Scene) -> Followed | None:
    """What a scene has taken of the table; None if it asks for no accuracy."""
    level = scene.solver.accuracy
    if not level:
        return None
    chosen: dict[str, Any] = {}
    stated: dict[str, Any] = {}
    wanted = attainable(scene, scene.yarn.elements_per_pitch, scene.yarn.degree)
    for name, option in wanted.items():
        *path, last = name.split(".")
        table = getattr(scene, path[0])
        value = getattr(table[int(path[1])] if len(path) == 2 else table, last)
        (chosen if value == option else stated)[name] = value
    return Followed(level, chosen, stated, choice(scene, level).reached)
