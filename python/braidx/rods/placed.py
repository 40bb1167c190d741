"""First guesses of rods that are placed elsewhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..system.terms import Floats, Ints
from .given import numbers
from .layout import Layout


def placed(layout: Layout, q: Floats, guess: Floats | Mapping[int, Floats] | None) -> Floats | None:
    """A state with rods where a first guess has them, shape (num_unknowns,), or None without one.

    Args:
        q: The state now, shape (num_unknowns,).
        guess: All unknowns, or nodes by number of the rod, shape (num_nodes, 3), mm; directors turn with the tangent at
            their node, as little as they can.
    Raises:
        ValueError: If the guess, or a line, has another shape, or numbers that are not finite.
    """
    if not isinstance(guess, Mapping):
        return None if guess is None else numbers("guess", guess, q.size)
    whole = q.copy()
    for rod, given in guess.items():
        unknowns = layout.unknowns(rod, slice(None))
        line = numbers(f"guess of rod {rod}", given, len(unknowns), 3)
        before, after = _tangents(q[unknowns[:, :3]]), _tangents(line)
        whole[unknowns[:, :3]] = line
        for first in range(3, unknowns.shape[1], 3):
            director = unknowns[:, first : first + 3]
            whole[director] = _turned(q[director], before, after)
        if rod in layout.sections:
            sections = layout.sections[rod].nodes[:, :, None] + np.arange(3)
            whole[sections] = _turned_sections(q, unknowns[:, :3], sections, line, before, after)
    return whole


def _turned_sections(
    q: Floats, centres: Ints, sections: Ints, line: Floats, before: Floats, after: Floats
) -> Floats:
    """Nodes of sections, shape (num_sections, nodes_per_section, 3), that keep their places in them."""
    from_centre = q[sections] - q[centres][:, None]
    tangents = (np.repeat(t, from_centre.shape[1], axis=0) for t in (before, after))
    turned = _turned(from_centre.reshape(-1, 3), *tangents)
    return np.asarray(line)[:, None] + turned.reshape(from_centre.shape)


def _tangents(line: Floats) -> Floats:
    tangents = np.gradient(line, axis=0)
    return np.asarray(tangents / np.linalg.norm(tangents, axis=1, keepdims=True))


def _turned(vectors: Floats, before: Floats, after: Floats) -> Floats:
    """Vectors turned as unit vectors `before` are turned into `after` on the shortest way; all shapes (n, 3).

    Two reflections, on the plane across `before` and on that across the middle of both; tangents that turn back have
    no shortest way, and stay what they are.
    """
    middle = before + after
    length = np.linalg.norm(middle, axis=1, keepdims=True)
    normals = np.where(length > 1e-6, middle / np.maximum(length, 1e-6), before)
    for normal in (before, normals):
        vectors = vectors - 2.0 * (vectors * normal).sum(axis=1, keepdims=True) * normal
    return vectors
