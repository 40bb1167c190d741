"""First guesses of the next equilibrium, and such as would lead to a wrong one."""

from __future__ import annotations

import numpy as np

from ..contact.contact import Contact
from ..solver.mumps import solve_once
from ..solver.trial import Diverged
from ..system.global_system import GlobalSystem
from ..system.terms import Floats
from .friction import without_friction
from .layout import Layout

# Of the distance of two nodes, what has to be left of it along the line where they were. Beams squeezed by more than
# that may find no way back.
FOLDED = 0.8
FOLLOWED = 0.5  # the same where others follow: rods that slide by more would know too late which way friction acts

FARTHEST = (
    2.0  # times the way that what is held may take it: what is free is not guessed to go farther
)


def follow_supports(
    system: GlobalSystem, layout: Layout, contact: Contact, start: Floats, first: Floats
) -> Floats | None:
    """What is free follows what is held as a linear system does that nothing rubs on.

    Friction is left out: where rods are held by it, as strands are, all of it is soon spent when they bend, and
    strands that could not slip would take forces a hundred times as large.

    Args:
        start: The last equilibrium, shape (num_unknowns,).
        first: A guess whose held unknowns are not where they are asked to go.
    Returns:
        The guess with held unknowns where they belong and the others moved along; None where no such way is found, or
        one that goes too far to be of use.
    """
    asked: Floats = system.expand(system.free_values(first)) - first
    if not asked.any():
        return first
    with without_friction(contact):
        system.update_pattern()
        system.set_state(start)
        system.set_step(np.zeros_like(start))
        system.assemble_tangent()
        right = system.vector.duplicate()
        system.scatter(system.constraints.reduce(system.tangent_times(asked)), right)
    moved = solve_once(system.matrix, right)
    follows = system.constraints.transform @ system.gather(moved)
    if not np.abs(follows[~layout.is_director]).max() <= FARTHEST * _reach(layout, asked):
        return None
    return np.asarray(first + asked - follows)


def _reach(layout: Layout, motion: Floats) -> float:
    """How far held nodes may take others: as far as they go themselves, or as their turns take an end, mm."""
    turns, size = layout.is_director, 0.0
    for rod in range(len(layout.first)):
        line = layout.rest[layout.unknowns(rod, slice(None))[:, :3]]
        size = max(size, float(np.ptp(line, axis=0).max()))
    moved = np.abs(motion[~turns]).max(initial=0.0)
    return float(max(moved, size * np.abs(motion[turns]).max(initial=0.0)))


def refuse_folds(layout: Layout, before: Floats, guess: Floats, least: float) -> None:
    """Held nodes that move far in one increment fold the elements beside them, which may stay folded: an equilibrium,
    but not the one that the motion leads to.

    Args:
        before, guess: Unknowns, shape (num_unknowns,); in the guess nothing but what is held has moved.
        least: FOLDED or FOLLOWED.
    Raises:
        Diverged: If two neighbours are folded towards each other.
    """
    for rod in range(len(layout.first)):
        positions = layout.unknowns(rod, slice(None))[:, :3]
        old, new = np.diff(before[positions], axis=0), np.diff(guess[positions], axis=0)
        left = np.einsum("ni,ni->n", new, old) / np.einsum("ni,ni->n", old, old)
        if left.min() < least:
            node = int(left.argmin())
            raise Diverged(
                f"the motion would fold rod {rod} between its nodes {node} and {node + 1}", 0, 0
            )
