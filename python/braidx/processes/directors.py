"""Directors of yarns whose positions are known, alike where the rope is kept symmetric."""

from __future__ import annotations

import numpy as np

from ..geometry import Rope, Rotations, build_rope, no_rotations, rotation_about_z, rotations
from ..scene import Form, Scene
from ..system.constraints import Floats


def formed_with_beams(scene: Scene) -> bool:
    """Whether yarns are beams while the rope is formed."""
    step = scene.steps[0]
    return isinstance(step, Form) and step.model == "beam"


def symmetry_of(scene: Scene, rope: Rope) -> Rotations:
    """Yarns that follow others, as far as the scene keeps the rope symmetric."""
    return rotations(rope) if scene.solver.symmetry else no_rotations(rope)


def with_directors(scene: Scene, positions: Floats) -> Floats:
    """Positions and directors, shape (9 num_nodes,); those of an image are turned with it.

    Args:
        scene: The scene.
        positions: Of all yarns, one after the other, shape (3 num_nodes,), mm.
    """
    symmetry = symmetry_of(scene, build_rope(scene))
    lines = np.split(positions.reshape(-1, 3), len(symmetry.leader))
    angles = 2.0 * np.pi * symmetry.turns / symmetry.fold
    parts = [
        np.hstack(
            [line, (periodic_directors(lines[leader]) @ rotation_about_z(angle)).reshape(-1, 6)]
        )
        for line, leader, angle in zip(lines, symmetry.leader, angles, strict=True)
    ]
    return np.concatenate(parts).ravel()


def periodic_directors(line: Floats) -> Floats:
    """Directors that are alike where tangents are: the x axis made normal to the yarn, and the third.

    Unlike rotation-minimising frames they agree at the two ends of a periodic yarn.
    """
    tangent = np.gradient(line, axis=0)
    tangent[0] = tangent[-1] = (line[1] - line[0] + line[-1] - line[-2]) / 2
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    first = np.array([1.0, 0.0, 0.0]) - tangent[:, :1] * tangent
    first /= np.linalg.norm(first, axis=1)[:, None]
    return np.stack([first, np.cross(tangent, first)], axis=1)
