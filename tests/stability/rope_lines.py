"""Where yarns of a straight rope are: overlaps, sides of crossings and windings, measured from centre lines alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from braidx.geometry import Rope
from lines import FINER, REACH, near_segments

Floats = npt.NDArray[np.float64]


def half_widths(
    directors: Floats | None, num_nodes: int, radius: float, finer: int = FINER
) -> Floats:
    """Tensors whose quadratic form with a unit vector is the square of a yarn's half width along it, mm^2.

    Args:
        directors: g1 and g2 of beams, shape (num_nodes, 2, 3); None: the section is a circle.
        finer: Points of the line from node to node.
    Returns:
        Between the points of the line, shape (finer (num_nodes - 1), 3, 3).
    """
    if directors is None:
        round_one = radius**2 * np.eye(3)
        return np.broadcast_to(round_one, (finer * (num_nodes - 1), 3, 3))
    t = (np.arange(finer) + 0.5)[None, :, None, None] / finer
    g = ((1.0 - t) * directors[:-1, None] + t * directors[1:, None]).reshape(-1, 2, 3)
    return np.asarray(radius**2 * np.einsum("nki,nkj->nij", g, g))


def deepest_overlap(
    lines: Sequence[Floats], halves: Sequence[Floats], goes_on: bool, length: float
) -> float:
    """Deepest overlap of two yarns, mm; negative where none touch.

    Args:
        lines: Smooth centre lines, shape (n, 3), mm.
        halves: Of each, tensors whose quadratic form with a unit vector is the square of the half width along it,
            shape (n, 3, 3), mm^2.
        goes_on: Whether the rope repeats itself past its ends.
        length: Of the sample, mm.
    """
    widest = max(float(np.sqrt(np.linalg.norm(half, 2, axis=(1, 2)).max())) for half in halves)
    deepest = -np.inf
    for a, b, shift in _pairs(len(lines), goes_on):
        other = lines[b] + [0.0, 0.0, shift * length]
        distance, which = near_segments(lines[a], other, REACH * 2.0 * widest)
        if not len(distance):
            continue
        i, j = which.T
        away = (other[j] + other[j + 1] - lines[a][i] - lines[a][i + 1]) / 2.0
        along = away / np.linalg.norm(away, axis=1, keepdims=True)
        width = sum(
            np.sqrt(np.einsum("ni,nij,nj->n", along, half[k], along))
            for half, k in ((halves[a], i), (halves[b], j))
        )
        deepest = max(deepest, float((width - distance).max()))
    return deepest


def _pairs(count: int, goes_on: bool) -> Iterator[tuple[int, int, int]]:
    for a in range(count):
        for b in range(a, count):
            for shift in (-1, 0, 1) if goes_on else (0,):
                if a != b:
                    yield a, b, shift


def windings(lines: Sequence[Floats]) -> Floats:
    """How often each yarn winds about each other one along the sample, shape (num_yarns, num_yarns).

    It cannot change unless yarns go through each other: where both ends stay alike it is a whole number.

    """
    z = np.linspace(max(line[0, 2] for line in lines), min(line[-1, 2] for line in lines), 4000)
    plane = np.array([across(line, z) for line in lines])
    away = plane[:, None] - plane[None, :]
    away[np.arange(len(lines)), np.arange(len(lines))] = 1.0
    return np.asarray(np.angle(away[..., 1:] / away[..., :-1]).sum(axis=2) / (2.0 * np.pi))


def across(line: Floats, z: Floats) -> npt.NDArray[np.complex128]:
    """Where a line is at given heights, x + i y, mm; where it turns back a little it is as far as it was."""
    height = np.maximum.accumulate(line[:, 2])
    return np.asarray(np.interp(z, height, line[:, 0]) + 1j * np.interp(z, height, line[:, 1]))


def crossing_sides(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """Where two yarns of opposite directions are at one angle about the axis, and how much farther out a is, mm.

    Args:
        a, b: Smooth centre lines, shape (n, 3), mm.
    Returns:
        Heights along the axis and differences of distances from it, both of shape (num_crossings,).
    """
    z = np.linspace(max(a[0, 2], b[0, 2]), min(a[-1, 2], b[-1, 2]), 4000)
    radii, angles = [], []
    for line in (a, b):
        place = across(line, z)
        radii.append(np.abs(place))
        angles.append(np.unwrap(np.angle(place)))
    turns = (angles[0] - angles[1]) / (2.0 * np.pi)
    at = np.flatnonzero(np.floor(turns[1:]) != np.floor(turns[:-1]))
    return z[at], (radii[0] - radii[1])[at]


def nearest_to_axis(line: Floats) -> float:
    """Distance of a line, shape (n, 3), from the rope's axis, mm."""
    return float(np.hypot(line[:, 0], line[:, 1]).min())


def wrong_sides(rope: Rope, lines: Sequence[Floats], length: float, goes_on: bool) -> int:
    """Crossings of yarns whose wrong one is outside, or that are not there.

    Yarns that come as near to the axis as their radius are on no side of it; only `windings` tells about them.

    Args:
        rope: What the recipe asks for.
        lines: Smooth centre lines, shape (n, 3), mm.
        length: Of the sample, mm.
        goes_on: Whether the rope repeats itself past its ends, across which a crossing may have moved.
    """
    crossings, wrong = rope.crossings, 0
    members = [np.flatnonzero(rope.strand == s) for s in range(rope.num_strands)]
    pairs = set(zip(crossings.strand_a.tolist(), crossings.strand_b.tolist(), strict=True))
    for strand_a, strand_b in pairs:
        chosen = (crossings.strand_a == strand_a) & (crossings.strand_b == strand_b)
        z, order = crossings.z[chosen], crossings.order[chosen]
        for a, b in ((a, b) for a in members[strand_a] for b in members[strand_b]):
            if min(nearest_to_axis(lines[a]), nearest_to_axis(lines[b])) < rope.radius[a]:
                continue
            heights, sides = crossing_sides(lines[a], lines[b])
            share = heights / length * rope.length
            apart = np.abs(share[:, None] - z[None, :])
            if goes_on:
                apart = np.minimum(apart, rope.length - apart)
            nearest = apart.argmin(axis=1)
            wrong += int(np.sum(order[nearest] * sides < 0.0))
            wrong += len(z) - len(set(nearest.tolist()))
    return wrong
