"""Closed rods: rings whose last node is their first one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..geometry.frames import nodal_tangents, rotation_minimising_frames
from ..system.constraints import Constraints
from ..system.terms import Floats, Ints
from .rod import Rod

COINCIDE = 1e-9  # of the size of a ring: what round-off may leave between its first and last node
LEAST = 4  # elements: contact geometry spans three, and a ring has to have another side


def check_rings(rods: Sequence[Rod]) -> None:
    """Refuses closed rods whose lines do not end where they begin.

    Raises:
        ValueError: The message names the rod.
    """
    for number, rod in enumerate(rods):
        if not rod.closed:
            continue
        line = np.asarray(rod.line, dtype=float)
        apart = float(np.linalg.norm(line[-1] - line[0]))
        if apart > COINCIDE * float(np.ptp(line, axis=0).max()):
            raise ValueError(
                f"rod {number} is closed, and its last node is {apart:.3g} mm from its first: end the line with its "
                "first node"
            )
        elements = (len(line) - 1) // rod.degree
        if elements < LEAST:
            raise ValueError(
                f"rod {number} is closed and has {elements} elements: give {LEAST} or more, {rod.degree} spans each"
            )


@dataclass(frozen=True)
class Joints:
    """Last nodes of closed rods, which follow the first ones.

    Attributes:
        rods: Numbers of the closed rods.
        followers, leaders: Unknowns of last and of first nodes, shape (n,).
    """

    rods: frozenset[int]
    followers: Ints
    leaders: Ints

    @classmethod
    def of(cls, rods: Sequence[Rod], first: Ints, block: Ints) -> Joints:
        """Joints of rods with their first unknowns and unknowns per node, shape (num_rods,)."""
        closed = [number for number, rod in enumerate(rods) if rod.closed]
        none = [np.empty(0, dtype=np.int64)]
        leaders = [first[i] + np.arange(block[i]) for i in closed]
        last = [own + block[i] * (len(rods[i].line) - 1) for i, own in zip(closed, leaders)]
        return cls(frozenset(closed), np.concatenate(none + last), np.concatenate(none + leaders))

    def constrain(self, constraints: Constraints) -> None:
        """Has last nodes follow the first ones."""
        constraints.tie(self.followers, self.leaders)

    def fold(self, forces: Floats) -> None:
        """What acts on last nodes acts on the first ones, in place, shape (num_unknowns,)."""
        forces[self.leaders] += forces[self.followers]
        forces[self.followers] = 0.0


def ring_directors(line: Floats) -> Floats:
    """Directors of a ring that turn about its line as evenly as they can, shape (num_nodes, 2, 3).

    Frames that do not spin come back turned about the tangent; that angle is spread evenly over the ring.
    """
    around = np.concatenate([line[-3:-1], line, line[1:3]])
    frames = rotation_minimising_frames([around])[0][2:-2]
    tangents = nodal_tangents(around)[2:-2]
    first, last = frames[0], frames[-1, 0]
    angle = np.arctan2(last @ first[1], last @ first[0])
    arc = np.append(0.0, np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum())
    turns = Rotation.from_rotvec(-(angle * arc / arc[-1])[:, None] * tangents)
    out = np.stack([turns.apply(frames[:, a]) for a in range(2)], axis=1)
    out[-1] = out[0]
    return np.asarray(out)
