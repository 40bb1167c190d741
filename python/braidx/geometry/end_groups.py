"""Which yarns belong to the groups of a scene's ends, and whether their conditions make sense for these."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.start_configuration import Rope
from braidx.scene.ends import AXES, EndConditions, EndGroup
from braidx.scene.errors import SceneError
from braidx.scene.scene import Scene
from braidx.scene.steps import Form, Hold, Settle

Integers = NDArray[np.int64]
NEAR = 1e-6  # of a yarn radius, and of 1: what counts as zero


def group_members(rope: Rope, group: EndGroup) -> list[Integers]:
    """Yarns of each of a table's groups."""
    number = _numbers(rope, group.level)
    which = group.which or range(int(number.max()) + 1)
    return [np.flatnonzero(number == i) for i in which]


def check_end_groups(scene: Scene, rope: Rope) -> None:
    """Raises SceneError, with the cure, where a scene's groups of ends contradict each other or the rope."""
    ends = scene.ends
    for i, group in enumerate(ends.groups):
        name = f"ends.groups[{i}]"
        _check_which(rope, group, name)
        _check_turns(scene, rope, group, name)
    for end in ("first", "last"):
        _check_bodies(rope, ends, end)
    _check_axis(scene, rope)
    _check_growth(scene)


def _numbers(rope: Rope, level: str) -> Integers:
    """Number of the group that each yarn belongs to, shape (num_yarns,)."""
    yarns = np.arange(rope.num_yarns)
    layer = rope.layer[rope.strand]
    return {"yarn": yarns, "strand": rope.strand, "layer": layer, "rope": 0 * yarns}[level]


def _check_which(rope: Rope, group: EndGroup, name: str) -> None:
    count = int(_numbers(rope, group.level).max()) + 1
    twice = len(set(group.which)) < len(group.which)
    if twice or max(group.which, default=0) >= count:
        cure = f"give numbers from 0 to {count - 1}, each once: so many of level {group.level} there are."
        raise SceneError(f"{name}.which", cure, group.which)


def _check_turns(scene: Scene, rope: Rope, group: EndGroup, name: str) -> None:
    """Ends on one line have no rotation about it, unless sections of beams tell it."""
    if scene.yarn.model == "beam" and scene.ends.sections == "fixed" and group.rigid:
        return
    harmless = ("free", "held") if group.rigid else ("free",)
    asked = {f"rotation.{axis}": angle for axis, angle in group.rotation.items()}
    asked = {key: angle for key, angle in asked.items() if angle not in harmless}
    asked |= {f"moment.{axis}": moment for axis, moment in group.moment.items()}
    for yarns in group_members(rope, group):
        lines = _lines(np.array([rope.centre_lines[yarn][0] for yarn in yarns]), scene.yarn.radius)
        for key, value in asked.items():
            if np.abs(lines[AXES.index(key[-1])]).max(initial=0.0) > NEAR:
                ends = "1 end" if len(yarns) == 1 else f"{len(yarns)} ends on one line"
                cure = (
                    f"{ends} of a {group.level} cannot turn about {key[-1]}; leave it out or choose a higher level "
                    '(beams: rigid = true and ends.sections = "fixed").'
                )
                raise SceneError(f"{name}.{key}", cure, value)


def _lines(ends: NDArray[np.float64], radius: float) -> NDArray[np.float64]:
    """Directions, in columns, about which points have no inertia."""
    arms = ends - ends.mean(axis=0)
    inertia, axes = np.linalg.eigh(np.sum(arms**2) * np.eye(3) - arms.T @ arms)
    return np.asarray(axes[:, inertia < (NEAR * radius) ** 2])


def _check_bodies(rope: Rope, ends: EndConditions, end: str) -> None:
    """An end belongs to one rigid body."""
    body = np.full(rope.num_yarns, -1)
    for i, group in enumerate(ends.groups):
        if group.rigid and group.end == end:
            yarns = np.concatenate(group_members(rope, group))
            if (body[yarns] >= 0).any():
                other = body[yarns][body[yarns] >= 0][0]
                cure = f"ends.groups[{other}] ties the same ends to another body; make one of them rigid = false."
                raise SceneError(f"ends.groups[{i}].rigid", cure, True)
            body[yarns] = i


def _check_axis(scene: Scene, rope: Rope) -> None:
    """Something has to hold the first end along the axis, and steps have to move the last one."""
    moves = [step.kind for step in scene.steps if not isinstance(step, (Form, Hold))]
    for end in ("first", "last"):
        if axially_held(scene.ends, rope, end) or not scene.steps:
            continue
        if end == "first":
            why = "nothing holds the rope along its axis at this end"
        elif moves:
            why = f"a step {moves[0]} moves the last end along the axis, and all groups are free there"
        else:
            continue
        group = next(i for i, g in enumerate(scene.ends.groups) if g.end == end and g.releases[2])
        cure = f'{why}; write displacement = {{ z = "held" }} and leave force.z out.'
        raise SceneError(f"ends.groups[{group}].displacement", cure)


def axially_held(ends: EndConditions, rope: Rope, end: str) -> bool:
    """Whether [ends] or a group holds any yarn's end along the axis, or the steps move it."""
    left = np.ones(rope.num_yarns, dtype=bool)
    for group in ends.groups:
        if group.end == end and group.releases[2]:
            left[np.concatenate(group_members(rope, group))] = False
    return bool(left.any()) or any(g.constrained[2] for g in ends.groups if g.end == end)


def _check_growth(scene: Scene) -> None:
    """What groups prescribe grows in steps that settle or hold."""
    grows = any(isinstance(step, (Settle, Hold)) and step.ends for step in scene.steps)
    for i, group in enumerate(scene.ends.groups):
        if group.prescribes and scene.steps and not grows:
            cure = 'its values grow in steps settle or hold: add one, such as kind = "hold" with increments = 20.'
            raise SceneError(f"ends.groups[{i}]", cure)
