"""Starts that are no equilibria, and rods that nothing holds."""

from __future__ import annotations

import numpy as np

from ..system.constraints import ConstraintMap
from ..system.terms import Floats
from .chords import TINY
from .equilibria import Equilibria
from .layout import Layout
from .loads import Loads
from .path import Impossible, NotConverged
from .supports import Supports

BALANCED = (
    1e-6  # of the largest force: what nothing balances at a start that counts as an equilibrium
)


def take_off(equilibria: Equilibria, layout: Layout, loads: Loads, q: Floats) -> str:
    """Has forces that nothing balances at the start balanced by loads, which go off evenly on the way.

    A bent rod that would be straight, or a node that is held no more, is let go little by little.

    Args:
        q: Unknowns at the start, shape (num_unknowns,).
    Returns:
        What is out of balance, for a message; nothing where the start is an equilibrium.
    """
    left, scale = equilibria.out_of_balance(q)
    if float(np.linalg.norm(left)) <= max(BALANCED * scale, layout.round_off):
        return ""
    loads.balance(left)
    positions = [layout.unknowns(rod, slice(None))[:, :3] for rod in range(len(layout.first))]
    most = [float(np.linalg.norm(left[unknowns], axis=1).max()) for unknowns in positions]
    rod = int(np.argmax(most))
    node = int(np.linalg.norm(left[positions[rod]], axis=1).argmax())
    return (
        f"The start is out of balance: {most[rod]:.3g} N on node {node} of rod {rod} before anything is asked for, "
        "which the way takes off."
    )


def explained(
    failure: NotConverged, start: str, layout: Layout, supports: Supports
) -> NotConverged:
    """The failure with what is known of its cause."""
    if isinstance(failure.__cause__, Impossible):
        return failure
    floating = [str(rod) for rod in range(len(layout.first)) if floats(layout, supports, rod)]
    loose = ""
    if floating:
        what = (
            f"rod {floating[0]} floats" if len(floating) == 1 else f"rods {_listed(floating)} float"
        )
        loose = f"But for contact, {what}: supports let it move as a whole, so hold it, or give a viscosity."
    return NotConverged(" ".join(part for part in (str(failure), start, loose) if part))


def floats(layout: Layout, supports: Supports, rod: int) -> bool:
    """Whether supports, joints and groups let a rod move as a whole, alone, in some direction or about some axis."""
    modes = _rigid_modes(layout, rod)
    constraints = supports.constraints()
    lost = modes - constraints.transform @ modes[constraints.free]
    return bool(_rank(lost[lost.any(axis=1)]) < _rank(modes[modes.any(axis=1)]))


def refuse_idle_groups(layout: Layout, constraints: ConstraintMap) -> None:
    """Refuses rigid groups that can turn without moving a node, as about a line that their nodes are all on.

    Raises:
        ValueError: The message names the group.
    """
    for number, frame in enumerate(layout.frames):
        own = frame.unknowns[0]
        turns = np.zeros((layout.rest.size, 6))
        for axis, direction in enumerate(np.eye(3)):
            turns[own[3:], axis] = np.cross(direction, frame.rest[3:].reshape(3, 3)).ravel()
        # Where nodes are on a line beside the centre, the centre moves, too.
        turns[own[:3], 3:] = np.eye(3)
        seen = constraints.transform @ turns[constraints.free]
        seen[own] -= turns[own]
        rows = seen[seen.any(axis=1)]
        if len(rows) == 0 or _rank(rows / np.abs(rows).max(axis=0, initial=TINY)) < turns.shape[1]:
            raise ValueError(
                f"the rigid group {len(layout.first) + number} can turn without moving its nodes: hold its directors, "
                "components 3 to 11, or put a section or a node off the line of the others into it"
            )


def _rigid_modes(layout: Layout, rod: int) -> Floats:
    """Motions of a rod as a whole, shape (num_unknowns, 6)."""
    unknowns = layout.unknowns(rod, slice(None))
    positions, directors = unknowns[:, :3], unknowns[:, 3:].reshape(-1, 3)
    if rod in layout.sections:
        positions = np.concatenate(
            [positions, layout.sections[rod].nodes.reshape(-1, 1) + np.arange(3)]
        )
    arms = layout.rest[positions] - layout.rest[positions].mean(axis=0)
    size = float(np.abs(arms).max())
    modes = np.zeros((layout.rest.size, 6))
    for axis, direction in enumerate(np.eye(3)):
        modes[positions, axis] = direction
        modes[positions, 3 + axis] = np.cross(direction, arms) / size
        modes[directors, 3 + axis] = np.cross(direction, layout.rest[directors]) / size
    modes[layout.joints.followers] = modes[layout.joints.leaders]
    return modes


def _rank(rows: Floats) -> int:
    return int(np.linalg.matrix_rank(rows, tol=1e-9)) if len(rows) else 0


def _listed(names: list[str]) -> str:
    """The first few of many names."""
    most = 8  # of a message that is still read
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
