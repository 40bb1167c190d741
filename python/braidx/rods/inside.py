"""Nodes within solids, chosen by where they are at rest; planes of symmetry."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ..system.terms import Floats, Ints
from .given import numbers
from .layout import Layout

Where = Callable[[Floats], npt.ArrayLike] | npt.ArrayLike
ON_PLANE = 1e-6  # of the size of all rods: nodes nearer to a plane are on it
ASLANT = (
    1e-6  # of its length: a director that is less out of a plane, or out of its normal, is in it
)


def unknowns_inside(layout: Layout, rod: int, where: Where, components: Ints) -> Ints:
    """Unknowns that hold components of nodes of a solid.

    Nodes of its ends follow these: an end with chosen nodes is named as a whole.

    Args:
        where: Two corners of a box, shape (2, 3), mm, or what tells of points, shape (n, 3), whether they are chosen,
            shape (n,).
    Raises:
        ValueError: If the rod is no solid, or no node is there.
    """
    if rod not in layout.sections:
        layout.unknowns(rod, 0)
        raise ValueError(f"rod {rod} is no Solid: nothing is inside it, hold its nodes")
    sections = layout.sections[rod]
    points = layout.rest[sections.nodes.reshape(-1, 1) + np.arange(3)]
    chosen = _chosen(points, where).reshape(sections.nodes.shape)
    if not chosen.any():
        low, high = points.min(axis=0), points.max(axis=0)
        raise ValueError(f"where names no node of rod {rod}: they lie between {low} and {high}")
    found = [(sections.nodes[1:-1][chosen[1:-1]][:, None] + components).ravel()]
    for end in (0, sections.num_sections - 1):
        if chosen[end].any():
            vectors = sections.first + 9 * end + 3 * np.arange(3)
            found.append((vectors[:, None] + components).ravel())
    return np.concatenate(found)


def _chosen(points: Floats, where: Where) -> npt.NDArray[np.bool_]:
    if callable(where):
        chosen = np.asarray(where(points))
        if chosen.shape != (len(points),):
            raise ValueError(f"where gives shape {chosen.shape}: give one answer per point")
        return chosen.astype(bool)
    low, high = np.sort(numbers("where", where, 2, 3), axis=0)
    return np.asarray(np.all((points >= low) & (points <= high), axis=1))


def unknowns_on_plane(layout: Layout, q: Floats, axis: int, at: float) -> Ints:
    """Unknowns that are held where rods lie in, or end at, a plane of symmetry.

    Positions stay in the plane. Of directors in the plane what points out of it is held, of those across it what is
    in it.

    Args:
        axis: 0, 1 or 2: the plane is normal to x, y or z.
        at: Its place on that axis, mm.
    Raises:
        ValueError: If no node is on the plane, or a director there is neither in it nor across it.
    """
    if axis not in (0, 1, 2):
        raise ValueError(f"axis is {axis}: give 0, 1 or 2 for a plane normal to x, y or z")
    near = ON_PLANE * float(np.abs(layout.rest).max())
    found: list[Ints] = []
    for rod in range(len(layout.first)):
        if rod in layout.sections:
            nodes = layout.rest[layout.sections[rod].nodes.ravel() + axis]
            if np.any(np.abs(nodes - at) <= near):
                on_plane = lambda x: np.abs(x[:, axis] - at) <= near  # noqa: E731
                found.append(unknowns_inside(layout, rod, on_plane, np.array([axis])))
            continue
        unknowns = np.unique(layout.unknowns(rod, slice(None)), axis=0)
        for own in unknowns[np.abs(q[unknowns[:, axis]] - at) <= near]:
            found.append(own[[axis]])
            found += [_held_of(q, vector, axis, rod) for vector in own[3:].reshape(-1, 3)]
    if not found:
        raise ValueError(
            f"no node is on the plane at {at} mm across axis {axis}: rods end there or lie in it"
        )
    return np.concatenate(found)


def _held_of(q: Floats, director: Ints, axis: int, rod: int) -> Ints:
    """Unknowns of a director, shape (3,), that are none by symmetry."""
    unit = q[director] / np.linalg.norm(q[director])
    others = np.delete(np.arange(3), axis)
    if abs(unit[axis]) <= ASLANT:
        return director[[axis]]
    if np.abs(unit[others]).max() <= ASLANT:
        return director[others]
    raise ValueError(
        f"a director of rod {rod} is {unit} on the plane of symmetry: give `directors` that are in the plane or normal "
        "to it there"
    )
