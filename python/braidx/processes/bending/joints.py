"""What holds a bent rope together: yarns made whole, everything clamped at both ends."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...system.constraints import Constraints, Floats
from .assembly import Assembly
from .clamp import SIZE
from .pieces import join


def joints(assembly: Assembly) -> tuple[Constraints, Floats]:
    """Constraints and their values, shape (num_unknowns,), mm.

    The clamps are held in the plane of bending and move alike along the axis.
    """
    constraints = Constraints(len(assembly.start))
    values = np.zeros(len(assembly.start))
    for clamp in assembly.clamps:
        clamp.hold(constraints, values)
    assembly.sheave.hold(constraints, values)
    first, last = (clamp.axial for clamp in assembly.clamps)
    constraints.combine(first, [last], [-1.0])
    values[first] = assembly.start[first] + assembly.start[last]
    yarns = assembly.yarns()
    for pieces in yarns:
        for before, after in pairwise(pieces):
            join(constraints, values, before, after)
    ends = [(pieces[0], pieces[-1]) for pieces in yarns]
    if assembly.core is not None:
        ends.append((assembly.core, assembly.core))
    for pair in ends:
        for piece, section, clamp in zip(pair, (0, -1), assembly.clamps, strict=True):
            piece.clamp(constraints, section, clamp, assembly.start)
    if assembly.core is not None and assembly.core.directors:
        component = np.arange(3, SIZE)
        for section, clamp in zip((0, -1), assembly.clamps, strict=True):
            node = assembly.core.positions[section][0]
            constraints.tie(node + component, clamp.first_unknown + component)
    return constraints, values
