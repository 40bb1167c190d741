"""The start configuration of a rope: helices around helices (paper 1, 3.4.1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from braidx.geometry.checks import check_geometry
from braidx.geometry.end_groups import check_end_groups
from braidx.geometry.crossings import Crossings, find_crossings, no_crossings, phase_offset
from braidx.geometry.motif import motif_matrix
from braidx.geometry.strand import strand_section, yarn_pitch
from braidx.scene.scene import Scene

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Rope:
    """A rope along z from 0 to length; all nodes of all lines are uniform in z."""

    centre_lines: tuple[Array, ...]  # per yarn (num_nodes, 3), mm
    radius: Array  # (num_yarns,), mm
    strand: NDArray[np.int64]  # (num_yarns,), strand of each yarn
    layer: NDArray[np.int64]  # (num_strands,), layer (direction) of each strand
    strand_lines: tuple[Array, ...]  # per strand (num_nodes, 3), mm
    crossings: Crossings
    length: float  # mm
    pitch: float  # mm

    @property
    def num_yarns(self) -> int:
        return len(self.centre_lines)

    @property
    def num_strands(self) -> int:
        return len(self.strand_lines)

    @property
    def num_yarn_crossings(self) -> int:
        """Crossings of a yarn with a yarn, in all crossings of their strands."""
        yarns = np.bincount(self.strand, minlength=self.num_strands)
        return int(yarns[self.crossings.strand_a] @ yarns[self.crossings.strand_b])


@dataclass(frozen=True)
class StrandHelix:
    """Centre line of a strand: a helix around z; with radius 0 and infinite pitch the axis."""

    radius: float  # mm
    pitch: float  # mm
    sense: int  # +1 right-handed, -1 left-handed
    phase: float  # radians

    def point(self, z: Array) -> Array:
        """Points of the centre line at these z, shape (n, 3)."""
        angle = self._angle(z)
        return np.column_stack([self.radius * np.cos(angle), self.radius * np.sin(angle), z])

    def frame(self, z: Array) -> tuple[Array, Array]:
        """Outward radial vector e_r and t x e_r, t being the unit tangent; (n, 3) each."""
        angle, zero = self._angle(z), np.zeros_like(z)
        slope = self.sense * 2.0 * np.pi * self.radius / self.pitch
        sine, cosine = slope / np.hypot(slope, 1.0), 1.0 / np.hypot(slope, 1.0)
        radial = np.column_stack([np.cos(angle), np.sin(angle), zero])
        across = np.column_stack([-np.sin(angle) * cosine, np.cos(angle) * cosine, zero - sine])
        return radial, across

    def _angle(self, z: Array) -> Array:
        return self.phase + self.sense * 2.0 * np.pi * z / self.pitch


def build_rope(scene: Scene) -> Rope:
    """Place the yarns of a scene in their start configuration, interpenetrating as they are.

    Raises:
        SceneError: If the recipe cannot be placed (see `check_geometry`), or groups of its ends make no sense.
    """
    check_geometry(scene)
    intervals = scene.yarn.elements_per_pitch * scene.rope.pitches * scene.yarn.degree
    z = np.linspace(0.0, scene.length, intervals + 1, dtype=np.float64)
    helices, layer = _strands(scene)
    section = strand_section(scene.strand, scene.yarn.radius)
    places = list(zip(section.ring_radius, section.phase, strict=True))
    pitch = yarn_pitch(scene.strand, scene.rope.pitch)
    lines = tuple(
        place_yarn(helix, radius, phase, _lay(scene.strand.lay, helix) * 2.0 * np.pi / pitch, z)
        for helix in helices
        for radius, phase in places
    )
    rope = Rope(
        centre_lines=lines,
        radius=np.full(len(lines), scene.yarn.radius),
        strand=np.repeat(np.arange(len(helices)), section.num_yarns),
        layer=layer,
        strand_lines=tuple(helix.point(z) for helix in helices),
        crossings=_crossings(scene),
        length=scene.length,
        pitch=scene.rope.pitch,
    )
    check_end_groups(scene, rope)
    return rope


def place_yarn(helix: StrandHelix, radius: float, phase: float, rate: float, z: Array) -> Array:
    """Centre line of a yarn with its nodes exactly at the given z, shape (n, 3), mm.

    The yarn lies in the plane normal to the strand at the strand's height s, at the angle
    phase + rate s from the outward radial vector; s is solved for with Newton's method.

    Args:
        helix: Centre line of the strand.
        radius: Distance from it, mm.
        phase: Angle at s = 0, radians.
        rate: Turns, radians per mm of s; positive is right-handed.
        z: Heights of the nodes, shape (n,), mm.
    """
    s = z.copy()
    tilt = radius * helix.frame(z[:1])[1][0, 2]  # t x e_r rises by the same all along a helix
    for _ in range(20):  # `check_geometry` bounds |tilt rate| by 0.8: this converges in a few steps
        angle = phase + rate * s
        s -= (s + tilt * np.sin(angle) - z) / (1.0 + tilt * rate * np.cos(angle))
    radial, across = helix.frame(s)
    angle = (phase + rate * s)[:, None]
    line = helix.point(s) + radius * (np.cos(angle) * radial + np.sin(angle) * across)
    line[:, 2] = z
    return line


def _strands(scene: Scene) -> tuple[list[StrandHelix], NDArray[np.int64]]:
    """Centre lines of all strands, layer 0 first, and the layer of each."""
    pitch = scene.rope.pitch
    if scene.braid is None:
        return [StrandHelix(0.0, np.inf, 1, 0.0)], np.zeros(1, dtype=np.int64)
    counts = scene.braid.strands_per_direction
    offset = phase_offset((counts[0], counts[1]))
    helices = [
        StrandHelix(scene.braid.helix_radius, pitch, sense, start + 2.0 * np.pi * k / count)
        for sense, start, count in ((1, 0.0, counts[0]), (-1, offset, counts[1]))
        for k in range(count)
    ]
    return helices, np.repeat(np.arange(2), counts)


def _lay(lay: str, helix: StrandHelix) -> int:
    return {"Z": 1, "S": -1, "same": helix.sense, "opposite": -helix.sense}[lay]


def _crossings(scene: Scene) -> Crossings:
    if scene.braid is None:
        return no_crossings()
    counts = scene.braid.strands_per_direction
    matrix = motif_matrix(scene.braid.motif)
    return find_crossings(matrix, (counts[0], counts[1]), scene.rope.pitch, scene.length)
