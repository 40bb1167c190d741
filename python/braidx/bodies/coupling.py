"""Linear constraints between the end face of a stretch of solids and the end of a beam or a cable."""

from __future__ import annotations

import numpy as np

from ..system.constraints import Constraints
from .layout import FloatArray, IntArray


def follow_section(
    constraints: Constraints,
    values: FloatArray,
    face_unknowns: IntArray,
    section: FloatArray,
    first_unknown: int,
) -> None:
    """A face of solids follows the section of a beam's node exactly: x = x0 + xi1 g1 + xi2 g2.

    Forces and moments on the face, and what strains it, pass to the node: sections of beams stretch and shear alike.

    Args:
        constraints: Takes the constraints.
        values: Values of the constraints, shape (num_unknowns,), mm; set to zero for the face.
        face_unknowns: Unknowns of the positions of the face's nodes, shape (n, 3).
        section: Coordinates (xi1, xi2) of these nodes about the beam's axis, shape (n, 2), mm.
        first_unknown: First of the nine unknowns x0, g1, g2 of the beam's node.
    """
    face = _checked(face_unknowns, section.shape[:1])
    if section.shape != (len(face), 2):
        raise ValueError(f"section has shape {section.shape}: give ({len(face)}, 2)")
    leaders = first_unknown + np.arange(9).reshape(3, 3).T
    factors = np.column_stack([np.ones(len(face)), section])
    constraints.combine_each(
        face.ravel(), np.tile(leaders, (len(face), 1)), np.repeat(factors, 3, axis=0)
    )
    values[face] = 0.0


def follow_mean(
    constraints: Constraints,
    values: FloatArray,
    face_unknowns: IntArray,
    weights: FloatArray,
    first_unknown: int,
) -> None:
    """The end of a cable follows the mean position of a face of solids, which may turn and deform.

    The cable's tension acts on the face as an even stress.

    Args:
        constraints: Takes the constraints.
        values: Values of the constraints, shape (num_unknowns,), mm; set to zero for the cable's node.
        face_unknowns: Unknowns of the positions of the face's nodes, shape (n, 3).
        weights: Area of each of these nodes, shape (n,), mm^2 (Sweep.weights).
        first_unknown: First of the three unknowns of the cable's node.
    """
    face = _checked(face_unknowns, weights.shape)
    node = first_unknown + np.arange(3)
    share = weights / weights.sum()
    constraints.combine_each(node, face.T, np.tile(share, (3, 1)))
    values[node] = 0.0


def _checked(face_unknowns: IntArray, like: tuple[int, ...]) -> IntArray:
    face = np.asarray(face_unknowns, dtype=np.int64)
    if face.shape != (*like, 3):
        raise ValueError(
            f"face_unknowns has shape {face.shape}: give {(*like, 3)}, one row per node"
        )
    return face
