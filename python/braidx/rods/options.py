"""How equilibria of rods are sought, unless told otherwise."""

from __future__ import annotations

import numpy as np

from ..contact.contact import Contact
from ..solver.newton import NewtonOptions
from .layout import Layout

# Rods that hardly stretch: a step that bends them stretches them, too, and the next ones take that back.
PATIENCE = 20
MANY = 5000  # unknowns from which on factors of a tangent cost more than to solve with those of an earlier one


def newton_options(
    layout: Layout, contact: Contact, tolerance: float, max_step: float | None, patience: int
) -> NewtonOptions:
    """Options of Newton's method; see Rods for the arguments."""
    num_rods = len(layout.first)
    lines = (layout.rest[layout.unknowns(rod, slice(None))[:, :3]] for rod in range(num_rods))
    size = max(float(np.ptp(line, axis=0).max()) for line in lines)
    others = contact.layout.group is None and num_rods > 1
    itself = np.isfinite(contact.pairing.search.self_exclusion)
    touching = others or itself or len(contact.rigid) > 0
    return NewtonOptions(
        tolerance,
        max_iterations=60,
        max_step=max_step or (contact.min_radius if touching else size),
        symmetric=False,
        round_off=layout.round_off,
        vain=patience,
        max_turn=1.0,
        halving=True,
        lagged=layout.rest.size > MANY,
    )
