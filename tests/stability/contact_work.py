"""Work that contacts take from one state to another: on penetrations, and on slip that would be given back."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from braidx.output.contact_table import ContactTable
from braidx.scene import Scene

Floats = npt.NDArray[np.float64]


def contact_work(scene: Scene, begin: ContactTable, end: ContactTable, stretch: float) -> float:
    """Trapezium rule with the contacts of both states that are nearest to each other, mJ.

    That is not the difference of the energies in penalties and in elastic slip: penalties grow with the tension, which
    is no work but lets both shrink.

    Args:
        begin, end: Contacts of the two states.
        stretch: Length of the sample in the second over that in the first.
    """
    pairs = [
        np.stack([table.yarn_a, table.yarn_b], axis=1, dtype=np.int64) for table in (begin, end)
    ]
    springs = [_springs(scene, table) for table in (begin, end)]
    work = 0.0
    for pair in np.unique(np.vstack(pairs), axis=0):
        rows = [np.flatnonzero((both == pair).all(axis=1)) for both in pairs]
        if not all(map(len, rows)):
            continue  # in one of the states they are too far from each other to be found
        tree = cKDTree(begin.position[rows[0]] * [1.0, 1.0, stretch])
        nearest = rows[0][tree.query(end.position[rows[1]])[1]]
        (force, length), (last_force, last_length) = springs
        forces = (force[nearest] + last_force[rows[1]]) / 2.0
        work += float((forces * (last_length[rows[1]] - length[nearest])).sum())
    return work


def _springs(scene: Scene, table: ContactTable) -> tuple[Floats, Floats]:
    """Forces of contacts and what they have moved their springs by, both of shape (m, 4): normal and friction."""
    reversible, coefficient = (
        scene.contact.reversible_slip * scene.yarn.radius,
        scene.contact.friction,
    )
    most = np.maximum(coefficient * table.normal_force, 1e-300)
    slip = reversible * table.friction_force / most[:, None]
    forces = np.column_stack([table.normal_force, table.friction_force])
    return forces, np.column_stack([np.maximum(-table.gap, 0.0), slip])
