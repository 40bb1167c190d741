"""The two end sections of a sample: one rule for all ends, and groups of ends that have their own."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from braidx.scene.errors import SceneError
from braidx.scene.fields import Table, option

AXES = ("x", "y", "z")
CONDITION = {"keys": AXES, "choices": ("free", "held"), "pattern": "free|held"}
EXAMPLE = '"free", "held" or a number'
Six = tuple[float, ...]


@dataclass(frozen=True)
class EndGroup(Table):
    """Ends that are held, moved, turned or loaded together (paper 1, 2.4).

    `displacement` and `force` act on the group's centroid, `rotation` and `moment` about it, along and about the
    fixed axes x, y and z, the rope's axis. A rigid group's ends keep the distances that they have at the start of
    the first step that is not forming, and axes left out are held. Of a group that is not rigid only the mean
    displacement and the mean rotation (least squares) are constrained, and axes left out stay as [ends] says:
    across as `transverse`, along the axis as one plane. Where there is a force or a moment the group is free.
    """

    table: ClassVar[str] = "ends.groups"

    end: str = option(choices=("first", "last"), doc="End section, the last one being pulled.")
    level: str = option(
        choices=("yarn", "strand", "layer", "rope"),
        doc="One group per yarn, strand or layer (direction of braiding), or one of all yarns.",
    )
    which: tuple[int, ...] = option(
        (),
        minimum=0,
        doc="Numbers of the yarns, strands or layers meant, from 0 and in the order of the recipe; empty: all.",
    )
    rigid: bool = option(False, doc="Whether the ends of a group move as one rigid body.")
    displacement: dict[str, float | str] = option(
        {},
        unit="mm",
        example=EXAMPLE,
        **CONDITION,
        doc='Per axis: "free", "held" (along the axis: moved as the steps say), or moved by so much more.',
    )
    rotation: dict[str, float | str] = option(
        {},
        unit="degrees",
        example=EXAMPLE,
        **CONDITION,
        doc='Per axis: "free", "held", or turned by an angle: about z first, any number of turns, then tilted.',
    )
    force: dict[str, float] = option(
        {}, unit="kN", keys=AXES, doc="Force on each group, per axis; it keeps its direction."
    )
    moment: dict[str, float] = option(
        {}, unit="N mm", keys=AXES, doc="Moment on each group, per axis; it keeps its direction."
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        for load, motion in (("force", "displacement"), ("moment", "rotation")):
            for axis in getattr(self, load):
                condition = getattr(self, motion).get(axis, "free")
                if condition != "free":
                    cure = f'does no work, {motion}.{axis} is not "free"; leave one of the two out.'
                    raise SceneError(f"ends.groups.{load}.{axis}", cure, getattr(self, load)[axis])
        if not (self.rigid or self.displacement or self.rotation or self.force or self.moment):
            cure = "says nothing; give displacement, rotation, force or moment, or rigid = true."
            raise SceneError("ends.groups", cure)

    @property
    def constrained(self) -> tuple[bool, ...]:
        """Whether the motion is given, along x, y, z and about x, y, z."""
        left_out = "held" if self.rigid else "free"
        pairs = ((self.displacement, self.force), (self.rotation, self.moment))
        return tuple(
            axis not in loads and motions.get(axis, left_out) != "free"
            for motions, loads in pairs
            for axis in AXES
        )

    @property
    def motion(self) -> Six:
        """Displacement (mm) and rotation (radians) asked for, 0 where held or free."""
        given = [*(self.displacement.get(axis) for axis in AXES)]
        turned = [*(self.rotation.get(axis) for axis in AXES)]
        numbers = [0.0 if value is None or isinstance(value, str) else value for value in given]
        angles = [0.0 if value is None or isinstance(value, str) else value for value in turned]
        return (*numbers, *map(math.radians, angles))

    @property
    def loads(self) -> Six:
        """Force (N) and moment (N mm)."""
        force = [1e3 * self.force.get(axis, 0.0) for axis in AXES]
        return (*force, *(self.moment.get(axis, 0.0) for axis in AXES))

    @property
    def releases(self) -> tuple[bool, bool, bool]:
        """Components x, y, z of its ends that the group, and not [ends], is responsible for."""
        about = {*self.rotation, *self.moment}
        across, along = "z" in about, not about.isdisjoint("xy")
        given = {*self.displacement, *self.force}
        return (
            self.rigid or "x" in given or across,
            self.rigid or "y" in given or across,
            self.rigid or "z" in given or along,
        )

    @property
    def turns(self) -> bool:
        """Whether the scene speaks of the group's rotation."""
        return bool(self.rotation or self.moment)

    @property
    def prescribes(self) -> bool:
        """Whether anything has to grow to its value."""
        return any(self.motion) or any(self.loads)


@dataclass(frozen=True)
class EndConditions(Table):
    """The two end sections of the sample (paper 1, 2.4 and 3.4.3)."""

    table: ClassVar[str] = "ends"

    transverse: str = option(
        "periodic",
        choices=("periodic", "fixed", "free"),
        doc="Across the axis: the two ends of each yarn move alike, stay where they are, or are "
        "free.",
        needs="ends",
    )
    sections: str = option(
        "free",
        choices=("free", "fixed"),
        doc="Directors of beams at the two ends; those of a rigid group turn with it if they are fixed. Where the rope "
        "goes on past its ends they turn alike.",
        needs="ends of beams",
    )
    groups: tuple[EndGroup, ...] = option(
        (),
        doc="Groups of ends with conditions of their own, one table [[ends.groups]] each.",
        needs="straight steps",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        for i, group in enumerate(self.groups):
            if self.transverse == "periodic" and group.end == "last" and any(group.releases[:2]):
                raise SceneError(
                    f"ends.groups[{i}].end",
                    'ends.transverse = "periodic" moves the last ends across the axis as the first ones; choose '
                    '"fixed" or "free" there, or give the group end = "first".',
                    group.end,
                )
