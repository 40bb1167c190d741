"""Finite rotations of a section: which one fits best, and its angles, turn about z and then tilt.

Angles are (tilt x, tilt y, turn z), radians: the rotation is exp of the vector (tilt x, tilt y, 0) after a turn about
the z axis. Unlike a rotation vector this knows no largest turn; a tilt is less than half a turn.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
FAINT = 1e-9  # weight, beside the vectors, of the wish not to tilt: it decides where they lie on one line


def best_fit(arms: Array, vectors: Array) -> Array:
    """The rotation R with the smallest sum of |vectors - R arms|^2; shapes (n, 3), result (3, 3)."""
    moments = vectors.T @ arms
    size = max(float(np.einsum("ij,ij->", arms, arms)), 1e-30)
    moments += FAINT * size * np.diag([FAINT, FAINT, 1.0])
    left, _, right = np.linalg.svd(moments)
    proper = np.diag([1.0, 1.0, np.linalg.det(left @ right)])
    return np.asarray(left @ proper @ right)


def angles_of(rotation: Array) -> Array:
    """Tilts and turn of a rotation, shape (3,), radians; the turn is between -pi and pi."""
    x, y, z, w = Rotation.from_matrix(rotation).as_quat()
    turn = 2.0 * np.arctan2(z, w)
    turn -= 2.0 * np.pi * np.round(turn / (2.0 * np.pi))
    tilt = Rotation.from_matrix(rotation) * Rotation.from_rotvec([0.0, 0.0, -turn])
    return np.array([*tilt.as_rotvec()[:2], turn])


def rotation_of(angles: Array) -> Array:
    """The rotation with these tilts and this turn, shape (3, 3)."""
    turn = Rotation.from_rotvec([0.0, 0.0, angles[2]])
    return np.asarray((Rotation.from_rotvec([angles[0], angles[1], 0.0]) * turn).as_matrix())


def rates_of(angles: Array) -> Array:
    """Column k is the infinitesimal rotation per change of angle k, shape (3, 3)."""
    tilt = np.array([angles[0], angles[1], 0.0])
    size = np.linalg.norm(tilt)
    cross = cross_matrix(tilt)
    first = (1.0 - np.cos(size)) / size**2 if size > 1e-4 else 0.5
    second = (size - np.sin(size)) / size**3 if size > 1e-4 else 1.0 / 6.0
    rates = np.eye(3) + first * cross + second * cross @ cross
    rates[:, 2] = Rotation.from_rotvec(tilt).as_matrix()[:, 2]
    return rates


def cross_matrix(vector: Array) -> Array:
    """Matrix of the cross product vector x, shape (3, 3)."""
    x, y, z = vector
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
