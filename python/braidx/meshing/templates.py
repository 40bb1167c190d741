"""Templates of sections: blocks of quadrilaterals, glued where their nodes meet."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from .reference import QUAD_EDGES, QUADS, FloatArray, IntArray
from .section import SectionMesh

Curve = Callable[[FloatArray], FloatArray]  # (n,) in 0 to 1 -> (n, 2)


@dataclass(frozen=True)
class _Block:
    """A map of the unit square, right-handed, and the number of quadrilaterals along u and v."""

    place: Callable[[FloatArray, FloatArray], FloatArray]
    counts: tuple[int, int]


def rectangle(
    width: float, height: float, counts: tuple[int, int] = (1, 1), degree: int = 1
) -> SectionMesh:
    """Rectangle of `width` along director 1 and `height` along director 2, mm, with counts of quadrilaterals."""
    size = np.array([_positive(width, "width"), _positive(height, "height")])
    block = _Block(lambda u, v: (np.stack([u, v], axis=-1) - 0.5) * size, counts)
    return _glue([block], degree, hollow=0.0)


def round_section(
    radius: float,
    seeds: int = 12,
    *,
    template: str = "o-grid",
    rings: int = 1,
    degree: int = 1,
    inner_radius: float = 0.0,
    equal_area: bool = False,
) -> SectionMesh:
    """Section of a round yarn or core, solid or hollow.

    Args:
        radius: Of the nodes on the circumference, mm.
        seeds: Edges round the circumference.
        template: "o-grid": a square core of seeds / 4 by seeds / 4 quadrilaterals in rings of them; "wedge": kites
            about the centre, two seeds wide, in rings; without effect on hollow sections, which have rings only.
        rings: Of quadrilaterals around the core, about the centre, or from the inner radius to the outer one.
        degree: Of the cells, 1 or 2.
        inner_radius: Of a hollow section, mm; 0: solid.
        equal_area: Enlarge the polygon so that its area is that of the circle.
    Raises:
        ValueError: If a number does not fit the template.
    """
    _positive(radius, "radius")
    if not 0.0 <= inner_radius < radius:
        raise ValueError(
            f"inner_radius is {inner_radius} mm: give 0 or less than radius ({radius} mm)"
        )
    if rings < 1:
        raise ValueError(f"rings is {rings}: give at least 1")
    if inner_radius > 0.0:
        _check_seeds(seeds, 1, 3, "a ring")
        blocks = _ring(inner_radius, radius, seeds, rings)
    elif template == "o-grid":
        _check_seeds(seeds, 4, 4, "an o-grid")
        blocks = _o_grid(radius, seeds // 4, rings)
    elif template == "wedge":
        _check_seeds(seeds, 2, 6, "a wedge")
        blocks = _wedge(radius, seeds, rings)
    else:
        raise ValueError(f'template is "{template}": give "o-grid" or "wedge"')
    section = _glue(blocks, degree, inner_radius / radius)
    return section.scaled_to(math.pi * (radius**2 - inner_radius**2)) if equal_area else section


def _arc(radius: float, first: float, last: float) -> Curve:
    """Arc about the centre, from the angle `first` to `last`."""

    def place(s: FloatArray) -> FloatArray:
        angle = first + (last - first) * s
        return radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)

    return place


def _blend(first: Curve, last: Curve, share: float) -> Curve:
    return lambda s: (1.0 - share) * first(s) + share * last(s)


def _chord(curve: Curve) -> Curve:
    ends = curve(np.array([0.0, 1.0]))
    return lambda s: (1.0 - s)[..., None] * ends[0] + s[..., None] * ends[1]


def _between(inner: Curve, outer: Curve, counts: tuple[int, int]) -> _Block:
    """Straight lines along u from a curve at u = 0 to one at u = 1, both run through along v."""
    return _Block(lambda u, v: (1.0 - u)[..., None] * inner(v) + u[..., None] * outer(v), counts)


def _patch(south: Curve, north: Curve, west: Curve, east: Curve, count: int) -> _Block:
    """Coons patch between curves along u (south, north) and along v (west, east)."""

    def place(u: FloatArray, v: FloatArray) -> FloatArray:
        a, b = u[..., None], v[..., None]
        along = (1.0 - b) * south(u) + b * north(u) + (1.0 - a) * west(v) + a * east(v)
        return along - (1.0 - b) * _chord(south)(u) - b * _chord(north)(u)

    return _Block(place, (count, count))


def _ring(inner: float, outer: float, seeds: int, rings: int) -> list[_Block]:
    step = 2.0 * math.pi / seeds
    return [
        _between(
            _arc(inner, i * step, (i + 1) * step), _arc(outer, i * step, (i + 1) * step), (rings, 1)
        )
        for i in range(seeds)
    ]


def _o_grid(radius: float, count: int, rings: int) -> list[_Block]:
    # Rings a little thicker than the quadrilaterals of the core, whose sides bulge half-way to a circle.
    core = radius / (1.0 + 1.2 * math.sqrt(2.0) * rings / count)
    quarters = [(-0.75 + 0.5 * i, -0.25 + 0.5 * i) for i in range(4)]
    sides, arcs = [], []
    for first, last in quarters:
        circle = _arc(core, first * math.pi, last * math.pi)
        sides.append(_blend(_chord(circle), circle, 0.5))
        arcs.append(_arc(radius, first * math.pi, last * math.pi))
    south, east, north, west = sides
    core_block = _patch(south, lambda s: north(1.0 - s), lambda s: west(1.0 - s), east, count)
    return [core_block, *(_between(a, b, (rings, count)) for a, b in zip(sides, arcs))]


def _wedge(radius: float, seeds: int, rings: int) -> list[_Block]:
    step, tip = 2.0 * math.pi / seeds, radius / rings
    kites = [_kite(tip, i * step, step) for i in range(0, seeds, 2)]
    return kites + (_ring(tip, radius, seeds, rings - 1) if rings > 1 else [])


def _kite(radius: float, first: float, step: float) -> _Block:
    """Quadrilateral of the centre and three points on a circle, `step` apart."""
    start, end = _arc(radius, first, first + step), _arc(radius, first + 2.0 * step, first + step)
    return _patch(_spoke(start), end, _spoke(end), start, 1)


def _spoke(curve: Curve) -> Curve:
    """Straight line from the centre to the start of a curve."""
    tip = curve(np.zeros(1))
    return lambda s: s[..., None] * tip


def _glue(blocks: Sequence[_Block], degree: int, hollow: float) -> SectionMesh:
    """One mesh of all blocks; `hollow` is the inner radius over the outer one."""
    if degree not in QUADS:
        raise ValueError(f"degree is {degree}: give 1 or 2")
    samples = [_sample(block, degree) for block in blocks]
    first = np.cumsum([0] + [len(points) for points, _ in samples])
    points = np.concatenate([points for points, _ in samples])
    quads = np.concatenate([cells + start for (_, cells), start in zip(samples, first)])
    near = cKDTree(points).query_ball_point(points, 1e-9 * np.ptp(points))
    kept, number = np.unique([min(same) for same in near], return_inverse=True)
    points, quads = points[kept], number[quads]
    edges = _boundary(quads)
    ends = points[quads[edges[:, 0, None], QUAD_EDGES[edges[:, 1]]]]
    distance = np.linalg.norm(ends, axis=2).max(axis=1)
    inner = (distance < 0.5 * (1.0 + hollow) * distance.max()) & (hollow > 0.0)
    return SectionMesh(points, quads, edges[~inner], edges[inner])


def _sample(block: _Block, degree: int) -> tuple[FloatArray, IntArray]:
    """Nodes of a block and its quadrilaterals."""
    counts = np.array(block.counts)
    sides = [np.linspace(0.0, 1.0, degree * n + 1) for n in counts]
    u, v = (grid.ravel() for grid in np.meshgrid(*sides, indexing="ij"))
    corner = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(
        -1, 1, 2
    )
    grid = degree * corner + np.round(degree * QUADS[degree].points).astype(np.int64)
    return block.place(u, v), grid[..., 0] * (degree * counts[1] + 1) + grid[..., 1]


def _boundary(quads: IntArray) -> IntArray:
    """(quad, local edge) of the edges that belong to one quadrilateral only."""
    ends = np.sort(quads[:, QUAD_EDGES], axis=2).reshape(-1, 2)
    _, number, count = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    return np.argwhere((count[number.ravel()] == 1).reshape(len(quads), -1))


def _positive(value: float, name: str) -> float:
    if not value > 0.0:
        raise ValueError(f"{name} is {value} mm: it must be positive")
    return value


def _check_seeds(seeds: int, step: int, least: int, template: str) -> None:
    if seeds % step or seeds < least:
        raise ValueError(
            f"seeds is {seeds}: {template} takes a multiple of {step}, at least {least}"
        )
