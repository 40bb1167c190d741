"""Cross-sections of a rope: the real cut of each yarn's tube by a plane z = const.

Near the plane a tube is straight: its section, centre + cos(phi) r g1 + sin(phi) r g2, is carried
along its tangent t. Moving each point of the section along t into the plane is an affine map, so
that the cut is the ellipse c + cos(phi) a1 + sin(phi) a2 with a_k = r (g_k - t g_kz / t_z): a yarn
inclined by theta to the rope axis gives semi-axes r and r / cos(theta). The curvature kappa of the
yarn within the cut is neglected (relative error of order kappa r tan(theta)).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.output.snapshot import Array, Snapshot

_STEEPEST = 0.05  # smallest |t_z|: a yarn nearly parallel to the plane has no bounded cut


@dataclass(frozen=True)
class Cut:
    """The ellipses of all yarns in one plane (m of them)."""

    z: float  # mm
    centre: Array  # (m, 2), mm
    axes: Array  # (m, 2, 2), mm: conjugate half diameters a1, a2
    yarn: NDArray[np.int64]  # (m,)

    def support(self, directions: Array) -> Array:
        """Distance from the rope axis to the tangent line of each ellipse across each direction.

        Args:
            directions: Unit vectors in the plane, shape (n, 2).
        Returns:
            Support function max over the ellipse of p . direction, shape (m, n), mm.
        """
        reach = np.einsum("mkc,nc->mkn", self.axes, directions)
        distance: Array = self.centre @ directions.T + np.hypot(reach[:, 0], reach[:, 1])
        return distance

    def area(self) -> Array:
        """Area of each ellipse, shape (m,), mm^2."""
        a1, a2 = self.axes[:, 0], self.axes[:, 1]
        return np.pi * np.abs(a1[:, 0] * a2[:, 1] - a1[:, 1] * a2[:, 0])

    def outlines(self, points: int = 48) -> Array:
        """Points on each ellipse, shape (m, points, 2), mm."""
        phi = np.linspace(0.0, 2 * np.pi, points, endpoint=False)
        circle = np.stack([np.cos(phi), np.sin(phi)])
        outline: Array = self.centre[:, None, :] + np.einsum("mkc,kn->mnc", self.axes, circle)
        return outline


def cut(snapshot: Snapshot, z: float) -> Cut:
    """Cut all yarns by the plane z = const (mm); a yarn may be cut several times or not at all."""
    centres, axes, yarns = [], [], []
    for yarn, line in enumerate(snapshot.centre_lines):
        above = line[:, 2] > z
        at = np.flatnonzero(above[1:] != above[:-1])
        if not len(at):
            continue
        height = line[:, 2]
        share = ((z - height[at]) / (height[at + 1] - height[at]))[:, None]
        mix = _mixer(at, share)
        tangent = _unit(mix(node_tangents(line)))
        tangent[:, 2] = np.where(tangent[:, 2] < 0, -1, 1) * np.maximum(
            np.abs(tangent[:, 2]), _STEEPEST
        )
        if snapshot.directors is None:
            section = frames(tangent)
        else:
            directors = snapshot.directors[yarn]
            section = np.stack([mix(directors[:, k]) for k in range(2)], axis=1)
        slope = section[:, :, 2] / tangent[:, None, 2]
        flat = section[:, :, :2] - slope[:, :, None] * tangent[:, None, :2]
        centres.append(mix(line)[:, :2])
        axes.append(snapshot.radius[yarn] * flat)
        yarns.append(np.full(len(at), yarn))
    if not centres:
        return Cut(z, np.empty((0, 2)), np.empty((0, 2, 2)), np.empty(0, dtype=np.int64))
    return Cut(z, np.concatenate(centres), np.concatenate(axes), np.concatenate(yarns))


def node_tangents(line: Array) -> Array:
    """Unit tangents at the nodes of a centre line, shape (n, 3): mean of the adjacent segments'."""
    along = _unit(np.diff(line, axis=0))
    return _unit(np.concatenate([along[:1], along[1:] + along[:-1], along[-1:]]))


def frames(tangent: Array) -> Array:
    """Two unit vectors across each tangent of one curve, shape (m, 2, 3), smooth along it.

    They are built from the direction that the tangents, taken together, point along least.
    """
    least = np.linalg.eigh(tangent.T @ tangent)[1][:, 0]
    first = _unit(np.cross(tangent, least))
    return np.stack([first, np.cross(tangent, first)], axis=1)


def _unit(vectors: Array) -> Array:
    unit: Array = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return unit


class _mixer:
    """Linear interpolation of nodal values at given segments."""

    def __init__(self, at: NDArray[np.int64], share: Array) -> None:
        self._at, self._share = at, share

    def __call__(self, values: Array) -> Array:
        mixed: Array = (1 - self._share) * values[self._at] + self._share * values[self._at + 1]
        return mixed
