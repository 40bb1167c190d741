"""Pitches that are alike, and rotations about the axis that bring a rope's start configuration back to itself.
Stacking order included.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from braidx.geometry.rope import Rope, build_rope
from braidx.scene.scene import Scene

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
NEAR = 1e-6  # of a yarn radius: lines that coincide


def goes_on(scene: Scene) -> bool:
    """Whether a rope goes on past its ends as it does at the other end."""
    return scene.ends.transverse == "periodic" and not scene.ends.groups


def one_for_all(scene: Scene) -> bool:
    """Whether one pitch of the straight rope stands for all: they are alike if it goes on and is kept symmetric."""
    return goes_on(scene) and (scene.solver.symmetry or scene.rope.pitches == 1)


def one_pitch(scene: Scene) -> Rope:
    """One pitch of the start configuration."""
    return build_rope(scene, pitches=1)


@dataclass(frozen=True)
class Rotations:
    """Each yarn is an image of a leading one, turned about z so many times by 2 pi / fold.

    Attributes:
        fold: Number of rotations that bring the rope back to itself; 1: none but the identity.
        leader: shape (num_yarns,), a yarn; leading yarns lead themselves.
        turns: shape (num_yarns,), 0 to fold - 1.
    """

    fold: int
    leader: Integers
    turns: Integers


def rotations(rope: Rope) -> Rotations:
    """The largest group of rotations of the start configuration."""
    most = int(np.bincount(rope.layer).min())
    for fold in range(most, 1, -1):
        image = _images(rope, 2.0 * np.pi / fold)
        if image is not None and _keeps_order(rope, image):
            return _orbits(image, fold)
    return no_rotations(rope)


def no_rotations(rope: Rope) -> Rotations:
    """Each yarn leads itself."""
    yarns = np.arange(rope.num_yarns)
    return Rotations(1, yarns, 0 * yarns)


def rotation_about_z(angle: float) -> Array:
    """Matrix that turns row vectors by an angle (radians) when it is multiplied from the right, shape (3, 3)."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def _images(rope: Rope, angle: float) -> Integers | None:
    """The yarn that each yarn is turned onto, or None if one is turned onto no other."""
    lines = np.array(rope.centre_lines)
    turned = lines @ rotation_about_z(angle)
    tree = cKDTree(lines.reshape(len(lines), -1))
    distance, image = tree.query(turned.reshape(len(lines), -1))
    near = distance < NEAR * rope.radius.min() * np.sqrt(lines.shape[1])
    return np.asarray(image, dtype=np.int64) if near.all() else None


def _keeps_order(rope: Rope, image: Integers) -> bool:
    """Whether crossings are turned onto crossings with the same stacking order."""
    onto = np.empty(rope.num_strands, dtype=np.int64)
    onto[rope.strand] = rope.strand[image]
    crossings = rope.crossings
    z = np.round(crossings.z / rope.pitch, 9)
    order = {
        (a, b, height): sign
        for a, b, height, sign in zip(
            crossings.strand_a, crossings.strand_b, z, crossings.order, strict=True
        )
    }
    return all(
        order.get((onto[a], onto[b], height)) == sign for (a, b, height), sign in order.items()
    )


def _orbits(image: Integers, fold: int) -> Rotations:
    leader, turns = np.full(len(image), -1), np.zeros(len(image), dtype=np.int64)
    for yarn in range(len(image)):
        at, turn = yarn, 0
        while leader[at] < 0:
            leader[at], turns[at] = yarn, turn
            at, turn = int(image[at]), turn + 1
    return Rotations(fold, leader, turns)
