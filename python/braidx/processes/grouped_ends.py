"""End sections of which groups of ends have conditions of their own (paper 1, 2.4)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import ClassVar

import numpy as np

from ..geometry import Rope, axially_held, group_members
from ..scene import EndConditions, EndGroup, Scene, SceneError
from ..system.constraints import ConstraintMap, Constraints, Floats, Ints
from ..system.equations import Dependent, impose
from .end_nodes import EndNodes
from .groups import Group, Pose

LEVELS = ("rope", "layer", "strand", "yarn")  # large groups first: small ones move with them


class GroupedEnds:
    """Constraints and loads on groups of ends; all other ends are as in Ends.

    Rigid groups and means are linear constraints of small motions from a state that meets them exactly. They are
    made anew for each increment, about its predicted end, so that finite rotations add up and bodies stay rigid.

    Attributes:
        nodes: The end nodes.
        length: Of the sample in the reference state, mm.

    Args:
        nodes: The end nodes.
        options: What the scene says.
        rope: Tells which yarns are a strand, a layer.
    Raises:
        SceneError: If a group's means follow from other conditions already.
    """

    grouped: ClassVar[bool] = True
    periodic: ClassVar[bool] = False

    def __init__(self, nodes: EndNodes, options: EndConditions, rope: Rope) -> None:
        self.nodes, self._options = nodes, options
        self.length = nodes.length
        self._driven = axially_held(options, rope, "last")
        # What [ends] still is responsible for, per yarn and unknown of its end node.
        components = np.arange(nodes.block)
        self._unknowns = {
            "first": nodes.first[:, None] + components,
            "last": nodes.last[:, None] + components,
        }
        ruled = (components < 3) | (options.sections == "fixed")
        self._ruled = {end: np.tile(ruled, (rope.num_yarns, 1)) for end in ("first", "last")}
        self._groups: list[tuple[int, Group]] = []
        # Means first and large groups first: bodies are placed last, and exactly.
        order = [(group.rigid, LEVELS.index(group.level)) for group in options.groups]
        for i in sorted(range(len(order)), key=order.__getitem__):
            for yarns in group_members(rope, options.groups[i]):
                self._groups.append((i, self._make(options.groups[i], yarns)))
        self.held(0.0)

    def strain(self, q: Floats, asked: float) -> float:
        """Strain of the rope: what was asked for, or what it is where groups move freely along the axis."""
        return asked if self._driven else self.nodes.distance(q) / self.length - 1.0

    def place(self, q: Floats, strain: float, share: float) -> Floats:
        """The state with its ends where the groups want them, as far as they do.

        Args:
            q: State predicted for the end of an increment, shape (num_unknowns,).
            strain: Rope strain there.
            share: How much is reached there of what groups ask for.
        """
        placed = q.copy()
        held, values = self._held(strain)
        placed[held] = values
        for group, pose in self._poses(placed, strain, share):
            group.place(placed, pose)
        return placed

    def bent(self, q: Floats) -> float:
        """Largest distance of an end of a rigid group from where it would be if the group were rigid, mm."""
        straight = q.copy()
        for _, group in self._groups:
            if group.options.rigid:
                group.place(straight, group.fit(q))
        return float(np.abs(straight - q).max())

    def carry(self, q: Floats, strain: float, share: float) -> Floats:
        """The state with its ends where the groups want them, and all of each yarn moved along in proportion."""
        rows = q.reshape(-1, self.nodes.block)
        change = (self.place(q, strain, share) - q).reshape(rows.shape)
        carried = rows.copy()
        for first, end in zip(self.nodes.curves[:-1], self.nodes.curves[1:], strict=True):
            along = np.linspace(0.0, 1.0, end - first)[:, None]
            carried[first:end] += (1.0 - along) * change[first] + along * change[end - 1]
        return carried.ravel()

    def loads(self, q: Floats, share: float) -> Floats:
        """Forces and moments of the groups as dead loads in the state q, shape (num_unknowns,), N."""
        loads = np.zeros_like(q)
        for _, group in self._groups:
            group.add_loads(loads, q, share)
        return loads

    def held(
        self, strain: float, share: float = 0.0, at: Floats | None = None
    ) -> tuple[ConstraintMap, Floats]:
        """Constraints at a rope strain.

        Args:
            strain: Rope strain from the reference state.
            share: How much is reached of what groups ask for.
            at: State to be linearised about, placed; the reference state by default.
        Returns:
            The constraint map and the values of its constraints, mm.
        """
        at = self.place(self.nodes.rest, strain, share) if at is None else at
        constraints, values = self._sections(strain)
        poses = [group.pose(at, self._axial(i, strain), share) for i, group in self._groups]
        for (i, group), pose in zip(self._groups, poses, strict=True):
            if group.options.rigid:
                group.tie(constraints, values, at, pose)
        self._impose_means(constraints, values, poses)
        return constraints.resolve(), values

    def _make(self, options: EndGroup, yarns: Ints) -> Group:
        """A group, and takes its ends out of what [ends] is responsible for."""
        ruled, unknowns = self._ruled[options.end], self._unknowns[options.end][yarns]
        directors = np.empty((0, 3), dtype=np.int64)
        ruled[yarns, :3] &= ~np.array(options.releases)
        if options.rigid and ruled[yarns, 3:].any():
            directors = unknowns[:, 3:].reshape(-1, 3)
            ruled[yarns, 3:] = False
        return Group(options, unknowns[:, :3], directors, self.nodes.rest)

    def _axial(self, number: int, strain: float) -> float:
        """Displacement along the axis that the steps ask of a group, mm."""
        return strain * self.length if self._options.groups[number].end == "last" else 0.0

    def _sections(self, strain: float) -> tuple[Constraints, Floats]:
        """What [ends] says about ends, or components, that no group is responsible for; see Ends."""
        rest = self.nodes.rest
        constraints, values = Constraints(len(rest)), np.zeros(len(rest))
        held, at = self._held(strain)
        constraints.hold(held)
        values[held] = at
        if self._options.transverse == "periodic":
            alike = self._ruled["last"] & (np.arange(self.nodes.block) != 2)
            first, last = self._unknowns["first"][alike], self._unknowns["last"][alike]
            constraints.tie(last, first)
            values[last] = rest[last] - rest[first]
        return constraints, values

    def _held(self, strain: float) -> tuple[Ints, Floats]:
        """Unknowns that [ends] holds at a rope strain, and their values."""
        along = np.arange(self.nodes.block) == 2
        held = along | (self._options.transverse == "fixed")
        first, last = (self._unknowns[end][self._ruled[end] & held] for end in ("first", "last"))
        moved = np.isin(last, self.nodes.last_axial) * strain * self.length
        values = np.concatenate([self.nodes.rest[first], self.nodes.rest[last] + moved])
        return np.concatenate([first, last]), values

    def _impose_means(
        self, constraints: Constraints, values: Floats, poses: Sequence[Pose]
    ) -> None:
        """Adds the equations of all means at once: they may speak of the same ends, and of bodies."""
        means = [
            (i, group.unknowns, *group.means(pose))
            for (i, group), pose in zip(self._groups, poses, strict=True)
            if not group.options.rigid
        ]
        if not means:
            return
        numbers = np.concatenate([np.full(len(wanted), i) for i, _, _, wanted in means])
        unknowns = np.unique(np.concatenate([each for _, each, _, _ in means]))
        rows = np.zeros((len(numbers), len(unknowns)))
        row = 0
        for _, each, own, _ in means:
            rows[row : row + len(own), np.searchsorted(unknowns, each)] = own
            row += len(own)
        try:
            impose(constraints, values, unknowns, rows, np.concatenate([m[3] for m in means]))
        except Dependent as error:
            raise self._redundant(int(numbers[error.row])) from None

    def _redundant(self, number: int) -> SceneError:
        others = [f"ends.groups[{i}]" for i in range(len(self._options.groups)) if i != number]
        given = ", ".join([*others, f'ends.transverse = "{self._options.transverse}"'])
        cure = (
            f"asks for what is given by other conditions already ({given}); leave one of them out."
        )
        return SceneError(f"ends.groups[{number}]", cure)

    def _poses(self, q: Floats, strain: float, share: float) -> Iterator[tuple[Group, Pose]]:
        """Groups and where they belong, one after the other: each sees what those before have moved."""
        for i, group in self._groups:
            yield group, group.pose(q, self._axial(i, strain), share)


def check_ends(scene: Scene, rope: Rope) -> None:
    """Raises SceneError where means of groups follow from other conditions, before anything is computed."""
    if scene.ends.groups:
        curves = np.cumsum([0, *map(len, rope.centre_lines)])
        GroupedEnds(
            EndNodes(3, curves, np.concatenate(rope.centre_lines).ravel()), scene.ends, rope
        )
